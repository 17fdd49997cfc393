// One viewer a case: two answers to wipe between, as V, shaded, or as the map of SSIM; the wheel or + and - zoom.
for (const viewer of document.querySelectorAll(".viewer")) {
  const stage = viewer.querySelector(".stage");
  const [left, right] = stage.querySelectorAll(".half img");
  const [first, second, kind] = viewer.querySelectorAll("select");
  const figures = [...viewer.querySelectorAll(".sheet figure")];
  let zoom = 1;

  // The truth has no map of how like the truth it is.
  const source = (stem, wanted) => `${stem}_${wanted === "ssim" && stem.endsWith("_truth") ? "v" : wanted}.png`;
  const show = () => {
    left.src = source(first.value, kind.value);
    right.src = source(second.value, kind.value);
    stage.querySelector("b.left").textContent = first.selectedOptions[0].text;
    stage.querySelector("b.right").textContent = second.selectedOptions[0].text;
    for (const figure of figures) {
      figure.classList.toggle("chosen", figure.dataset.stem === second.value);
      figure.querySelector("img").src = source(figure.dataset.stem, kind.value);
    }
  };
  const setZoom = (value) => {
    zoom = Math.min(16, Math.max(1, value));
    stage.style.setProperty("--zoom", zoom);
    stage.classList.toggle("near", zoom > 2);
  };

  for (const select of [first, second, kind]) select.addEventListener("change", show);
  for (const figure of figures) {
    figure.addEventListener("click", () => { second.value = figure.dataset.stem; show(); });
  }
  stage.addEventListener("pointermove", (event) => {
    const box = stage.getBoundingClientRect();
    const x = 100 * (event.clientX - box.left) / box.width;
    const y = 100 * (event.clientY - box.top) / box.height;
    stage.style.setProperty("--wipe", `${x}%`);
    if (event.shiftKey || zoom === 1) {
      stage.style.setProperty("--at-x", `${x}%`);
      stage.style.setProperty("--at-y", `${y}%`);
    }
  });
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    setZoom(zoom * (event.deltaY < 0 ? 1.25 : 0.8));
  }, { passive: false });
  stage.addEventListener("keydown", (event) => {
    if (event.key === "+") setZoom(zoom * 1.25);
    if (event.key === "-") setZoom(zoom * 0.8);
  });
  stage.addEventListener("dblclick", () => setZoom(1));
}
