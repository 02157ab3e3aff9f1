"use strict";
// The before/after slider: the reference stays below; the chosen technique's layers are cut at the handle.
const one = (id) => document.getElementById(id);
const [stage, cut, technique, view, zoom] = ["stage", "cut", "technique", "view", "zoom"].map(one);

function show() {
  const chosen = technique.selectedOptions[0];
  const isMarked = view.value !== "picture";
  one("over").className = `layer t${technique.value} ${view.value}`;
  one("under").classList.toggle("dimmed", isMarked);
  one("name").textContent = chosen.textContent + (isMarked ? ", " + view.selectedOptions[0].textContent : "");
  one("caption").textContent = chosen.dataset.caption;
}

function moveTo(percent) {
  cut.value = Math.min(100, Math.max(0, percent));
  stage.style.setProperty("--cut", cut.value + "%");
}

function drag(event) {
  const box = stage.getBoundingClientRect();
  moveTo(((event.clientX - box.left) / box.width) * 100);
}

technique.addEventListener("change", show);
view.addEventListener("change", show);
cut.addEventListener("input", () => moveTo(Number(cut.value)));
zoom.addEventListener("input", () => {
  stage.style.setProperty("--zoom", zoom.value);
  stage.classList.toggle("large", Number(zoom.value) > 1);
});
stage.addEventListener("pointerdown", (event) => {
  stage.setPointerCapture(event.pointerId);
  drag(event);
});
stage.addEventListener("pointermove", (event) => {
  if (event.buttons & 1) drag(event);
});
moveTo(50);
show();
