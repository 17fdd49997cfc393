// What moves: the live numbers, and the view.
const parameters = {{ parameters | tojson }};
const view = { turn: [0, 0], zoom: 1 };
const values = Object.fromEntries(parameters.map((parameter) => [parameter.name, parameter.default]));
const canvas = document.querySelector("canvas");

function say(problem) {
    const box = document.body.appendChild(document.createElement("pre"));
    box.id = "problem";
    box.textContent = problem;
    throw new Error(problem);
}

// A picture is drawn in strips, so that no driver thinks it hangs: first with one ray a pixel, then with four.
const FIRST_STRIP = { from: 0, height: 32, rays: 1 };

// The strip after one that took so long; null if the picture is drawn.
function following(strip, milliseconds) {
    const height = Math.min(4096, Math.max(8, Math.round(strip.height * Math.min(4, 60 / (milliseconds + 1)))));
    const from = strip.from + strip.height;
    if (from < canvas.height) return { from, height, rays: strip.rays };
    if (strip.rays === 1) return { from: 0, height, rays: 4 };
    document.body.dataset.drawn = "yes";
    return null;
}

// Lets a pointer turn the view and sliders set the numbers; the picture is then to be started anew.
function listen(restart, resize) {
    canvas.addEventListener("pointermove", (event) => {
        if (!event.buttons) return;
        view.turn[0] += event.movementX * 0.01;
        view.turn[1] += event.movementY * 0.01;
        restart();
    });
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
        view.zoom = Math.min(20, Math.max(0.05, view.zoom * Math.exp(event.deltaY * 0.001)));
        restart();
        event.preventDefault();
    }, { passive: false });

    const controls = document.getElementById("controls");
    for (const parameter of parameters) {
        const label = controls.appendChild(document.createElement("label"));
        label.title = parameter.text;
        label.append(parameter.is_time ? "time" : parameter.label);
        const slider = label.appendChild(document.createElement("input"));
        Object.assign(slider, { type: "range", min: parameter.min, max: parameter.max, step: parameter.step });
        slider.value = parameter.default;
        const shown = label.appendChild(document.createElement("output"));
        shown.value = slider.value;
        slider.addEventListener("input", () => {
            values[parameter.name] = Number(slider.value);
            shown.value = slider.value;
            restart();
        });
    }
    addEventListener("resize", resize);
    resize();
}
