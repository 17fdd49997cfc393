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

// A picture is drawn in strips, so that no driver thinks it hangs: each has as many rows as take about SPELL milliseconds.
const SPELL = 40;
let rows = 32;
// The picture that is being drawn. Its view and its numbers stay until it is whole.
let picture = null;
// Whether something has moved since that picture was begun.
let hasMoved = true;
// Whether the canvas shows a whole picture; until then it shows each strip.
let isCovered = false;

function moved() {
    hasMoved = true;
    delete document.body.dataset.drawn;
}

function begin(rays) {
    picture = { from: 0, rays, turn: [...view.turn], zoom: view.zoom, values: { ...values } };
    hasMoved = false;
}

// Draws for as long as the page is open: with one ray a pixel while something moves, then with four. `draw` draws so many
// rows of a picture, down from `picture.from`; `show` puts what is drawn on the canvas.
async function run(draw, show) {
    for (;;) {
        const now = await new Promise(requestAnimationFrame);
        if (clock.runs) tick(now);
        if (hasMoved && picture?.rays !== 1) begin(1);
        while (picture && performance.now() - now < SPELL) await drawStrip(draw, show);
    }
}

async function drawStrip(draw, show) {
    const drawn = picture;
    const height = Math.min(rows, canvas.height - drawn.from);
    const start = performance.now();
    await draw(drawn, height);
    const spent = performance.now() - start;
    rows = Math.min(4096, Math.max(8, Math.round(height * Math.min(4, SPELL / (spent + 1)))));
    // Meanwhile the canvas may have got another size.
    if (picture !== drawn) return;
    drawn.from += height;
    const isWhole = drawn.from === canvas.height;
    if (isWhole || drawn.rays > 1 || !isCovered) show();
    if (!isWhole) return;
    isCovered = true;
    picture = null;
    if (hasMoved || clock.runs) return;
    if (drawn.rays === 1) begin(4);
    else document.body.dataset.drawn = "yes";
}

// Gives the canvas the size that it has on the screen.
function fit() {
    canvas.width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio));
    canvas.height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
    picture = null;
    isCovered = false;
    moved();
}

// The clock of `$t`, which goes from 0 to 1 in so many milliseconds.
const PERIOD = 8000;
const time = parameters.find((parameter) => parameter.is_time);
const clock = { runs: false, start: 0, button: document.createElement("button"), slider: null };

function tick(now) {
    setNumber(time, clock.slider, (Math.max(0, now - clock.start) / PERIOD) % 1);
}

function play(runs) {
    clock.runs = runs;
    clock.start = performance.now() - values[time.name] * PERIOD;
    clock.button.textContent = runs ? "pause" : "play";
    moved();
}

function setNumber(parameter, slider, value) {
    values[parameter.name] = value;
    slider.value = value;
    slider.nextElementSibling.value = slider.value;
    moved();
}

// Lets a pointer turn the view, and sliders set the numbers.
function listen() {
    canvas.addEventListener("pointermove", (event) => {
        if (!event.buttons) return;
        view.turn[0] += event.movementX * 0.01;
        view.turn[1] += event.movementY * 0.01;
        moved();
    });
    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("wheel", (event) => {
        view.zoom = Math.min(20, Math.max(0.05, view.zoom * Math.exp(event.deltaY * 0.001)));
        moved();
        event.preventDefault();
    }, { passive: false });

    const controls = document.getElementById("controls");
    for (const parameter of parameters) {
        const label = controls.appendChild(document.createElement("label"));
        label.title = parameter.text;
        label.append(parameter.is_time ? "time" : parameter.label);
        const slider = label.appendChild(document.createElement("input"));
        label.append(document.createElement("output"));
        Object.assign(slider, { type: "range", min: parameter.min, max: parameter.max, step: parameter.step });
        setNumber(parameter, slider, parameter.default);
        slider.addEventListener("input", () => {
            if (parameter.is_time) play(false);
            setNumber(parameter, slider, Number(slider.value));
        });
        if (parameter.is_time) clock.slider = slider;
    }
    if (time) {
        controls.append(clock.button);
        clock.button.addEventListener("click", () => play(!clock.runs));
        // Who wants little motion starts the clock.
        play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
    }
}
