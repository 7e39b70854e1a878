/* Animations (workbook.display.animations): each gets a button and a slider; nothing moves before the button is pressed.
   Where the system is set to reduced motion, the button goes on by a step. */
addEventListener("DOMContentLoaded", () => {
  const reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
  for (const box of document.querySelectorAll(".animation[data-animation]")) {
    const {times, speed, still, parts} = JSON.parse(box.dataset.animation);
    const shapes = box.querySelectorAll(".moving");
    const last = times.length - 1;
    const controls = document.createElement("div");
    const button = document.createElement("button");
    const slider = document.createElement("input");
    const clock = document.createElement("output");
    controls.className = "animation-controls";
    button.type = "button";
    Object.assign(slider, {type: "range", min: 0, max: last, step: 1, value: still, ariaLabel: "Time of the motion"});
    controls.append(button, slider, clock);
    box.append(controls);
    let began = null;

    const set = (shape, values) => Object.entries(values).forEach(([name, value]) => shape.setAttribute(name, value));
    const show = (frame) => {
      parts.forEach(({kind, points: p}, k) => {
        const shape = shapes[k];
        if (kind === "dot") set(shape, {cx: p[2 * frame], cy: p[2 * frame + 1]});
        else if (kind === "rod") set(shape, {x1: p[4 * frame], y1: p[4 * frame + 1], x2: p[4 * frame + 2], y2: p[4 * frame + 3]});
        else set(shape, {points: p.slice(0, 2 * frame + 2).join(" ")});
      });
      slider.value = frame;
      clock.value = `t = ${times[frame].toFixed(2)}`;
      slider.ariaValueText = clock.value;
    };
    const stop = () => { began = null; label(); };
    const label = () => { button.textContent = reducedMotion.matches ? "Next step" : began === null ? "Play" : "Pause"; };
    const tick = (now) => {
      if (began === null) return;
      const at = began.time + (now - began.now) / 1000 * speed;
      let frame = Number(slider.value);
      while (frame < last && times[frame + 1] <= at) frame += 1;
      show(frame);
      frame < last ? requestAnimationFrame(tick) : stop();
    };
    button.addEventListener("click", () => {
      if (reducedMotion.matches) {
        const frame = Number(slider.value);
        show(frame === last ? 0 : Math.min(last, frame + Math.max(1, Math.round(last / 12))));
      } else if (began !== null) {
        stop();
      } else {
        if (Number(slider.value) === last) show(0);
        began = {now: performance.now(), time: times[slider.value]};
        label();
        requestAnimationFrame(tick);
      }
    });
    slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
    reducedMotion.addEventListener("change", stop);
    show(still);
    label();
  }
});
