/* Narrows the list of all problems. What is verified in this browser is marked by answer_boxes/progress.js. */

(() => {
  const form = document.querySelector("form.problem-filter");
  const rows = [...document.querySelectorAll("table.problem-list tbody tr")];
  const sections = new Set(rows.map((row) => row.closest("section")));

  function fits(row) {
    const { level, topic, minutes, varies, open } = form.elements;
    const has = (name) => !name || row.classList.contains(name);
    return has(level.value) && has(topic.value)
      && (!minutes.value || Number(row.cells[4].textContent) <= Number(minutes.value))
      && (!varies.checked || has("varies"))
      && (!open.checked || row.querySelector(".problem-verified")?.textContent !== "✓");
  }

  function narrow() {
    for (const row of rows) row.hidden = !fits(row);
    for (const section of sections) section.hidden = !section.querySelector("tbody tr:not([hidden])");
    const shown = rows.filter((row) => !row.hidden).length;
    form.querySelector("output").textContent = `${shown} of ${rows.length} problems`;
  }

  form.hidden = false;
  form.addEventListener("input", narrow);
  form.addEventListener("submit", (event) => event.preventDefault());
  addEventListener("pageshow", narrow); // the browser may restore what was chosen
})();
