/* Interactive figures (workbook.display.explorer). The declaration stands in data-explorer: parameters, steps, panels and
   sentences, whose formulas are JavaScript expressions in v, the scalars, and c, the columns of a row. A change recomputes and
   redraws, at once, what depends on it. Nothing moves unless the reader moves it. */
(() => {
  const LARGEST = 1e6, NEWTON_STEPS = 14;

  const compile = (code) => new Function("v", "c", `"use strict"; return ${code};`);

  /* Steps ------------------------------------------------------------------------------------------------------------- */

  function trajectory({rates, initial, end, points}, v) {
    const h = end(v)[0] / points;
    let row = [0, ...initial(v)];
    const rows = [row];
    const moved = (k, step) => row.map((value, i) => value + step * (i ? k[i - 1] : 1));
    for (let n = 1; n <= points; n += 1) {
      const k1 = rates(v, row), k2 = rates(v, moved(k1, h / 2)), k3 = rates(v, moved(k2, h / 2)), k4 = rates(v, moved(k3, h));
      row = row.map((value, i) => i ? value + h / 6 * (k1[i - 1] + 2 * k2[i - 1] + 2 * k3[i - 1] + k4[i - 1]) : n * h);
      if (!row.every((value, i) => !i || Math.abs(value) < LARGEST)) break;
      rows.push(row);
    }
    return rows;
  }

  function recursion({updates, initial, data, steps}, v) {
    const at = (n) => data.map((column) => column[n]);
    let states = initial(v);
    const rows = [[0, ...states, ...at(0)]];
    for (let n = 1; n <= steps; n += 1) {
      states = updates(v, [n, ...states, ...at(n)]);
      rows.push([n, ...states, ...at(n)]);
    }
    return rows;
  }

  function curve({low, high, points}, v) {
    const [first] = low(v), [last] = high(v);
    return Array.from({length: points + 1}, (_, n) => [first + (last - first) * n / points]);
  }

  /* Roots of a polynomial, highest coefficient first, by the iteration of Aberth and Ehrlich. */
  function roots(coefficients) {
    const scale = Math.max(...coefficients.map(Math.abs));
    const first = coefficients.findIndex((value) => Math.abs(value) > 1e-13 * scale);
    if (first < 0) return [];
    const p = coefficients.slice(first).map((value) => value / coefficients[first]);
    const degree = p.length - 1;
    const radius = Math.max(...p.slice(1).map((value, k) => Math.abs(value) ** (1 / (k + 1))), 1e-9);
    const z = Array.from({length: degree}, (_, k) => {
      const angle = 2 * Math.PI * k / degree + 0.7;
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    });
    const times = ([a, b], [c, d]) => [a * c - b * d, a * d + b * c];
    const over = ([a, b], [c, d]) => { const size = c * c + d * d; return [(a * c + b * d) / size, (b * c - a * d) / size]; };
    for (let sweep = 0, change = 1; sweep < 200 && change > 1e-15 * radius; sweep += 1) {
      change = 0;
      for (let k = 0; k < degree; k += 1) {
        let value = [1, 0], slope = [0, 0];
        for (const coefficient of p.slice(1)) {
          slope = times(slope, z[k]).map((part, i) => part + value[i]);
          value = times(value, z[k]);
          value[0] += coefficient;
        }
        if (!value[0] && !value[1]) continue;
        let pull = over(slope, value);
        z.forEach((other, j) => {
          const gap = [z[k][0] - other[0], z[k][1] - other[1]];
          if (j !== k && (gap[0] || gap[1])) { const part = over([1, 0], gap); pull = [pull[0] - part[0], pull[1] - part[1]]; }
        });
        const step = over([1, 0], pull);
        if (!Number.isFinite(step[0] + step[1])) continue;
        z[k] = [z[k][0] - step[0], z[k][1] - step[1]];
        change = Math.max(change, Math.hypot(...step));
      }
    }
    return z;
  }

  /* Equilibria in a window, by Newton's method from given points. */
  function equilibria({rates, slopes, ranges, data}, v) {
    const found = new Map();
    data[0].forEach((_, k) => {
      let z = data.map((column) => column[k]);
      for (let n = 0; n < NEWTON_STEPS; n += 1) {
        const [f, g] = rates(v, z), [a, b, c, d] = slopes(v, z), det = a * d - b * c;
        z = [z[0] - (d * f - b * g) / det, z[1] - (a * g - c * f) / det];
      }
      const key = z.map((value, i) => Math.round(1e4 * value / (ranges[i][1] - ranges[i][0]))).join();
      const inside = z.every((value, i) => ranges[i][0] <= value && value <= ranges[i][1]);
      if (inside && Math.hypot(...rates(v, z)) < 1e-9 && !found.has(key)) found.set(key, z);
    });
    return [...found.values()];
  }

  const SERIES = {trajectory, recursion, curve, equilibria, roots: ({coefficients}, v) => roots(coefficients(v)),
                  table: ({data}) => data[0].map((_, n) => data.map((column) => column[n]))};
  const SCALARS = {quantity: ({value}, v) => value(v)[0],
                   last: ({value, series}, v, rows) => value(v, rows[series].at(-1))[0],
                   largest: ({value, series}, v, rows) => Math.max(...rows[series].map((row) => value(v, row)[0]))};

  /* Text -------------------------------------------------------------------------------------------------------------- */

  function short(value) {
    if (!Number.isFinite(value)) return value > 0 ? "∞" : value < 0 ? "−∞" : "undefined";
    const rounded = Math.abs(value) < 5e-13 ? 0 : Number(value.toPrecision(3));
    const plain = Math.abs(rounded) >= 1e6 ? String(rounded) : rounded.toFixed(12).replace(/\.?0+$/, "");
    return plain.replace("-", "−");
  }

  /* Drawing ----------------------------------------------------------------------------------------------------------- */

  const WIDTH = 360, LEFT = 44, RIGHT = 12, TOP = 22, BOTTOM = 24, CELLS = 72, ARROWS = 15;

  function shape(name, attributes, parent, text) {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    set(element, attributes);
    if (text !== undefined) element.textContent = text;
    parent?.append(element);
    return element;
  }
  const set = (element, attributes) => Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
  function tag(name, properties, ...children) {
    const element = Object.assign(document.createElement(name), properties);
    element.append(...children);
    return element;
  }

  /* Ticks at multiples of 1, 2 or 5 times a power of ten, at most `count` of them. */
  function ticks([low, high], count) {
    const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
    const step = power * [1, 2, 5, 10].find((factor) => factor * power >= raw);
    const first = Math.ceil(low / step - 1e-9);
    return Array.from({length: Math.floor(high / step + 1e-9) - first + 1}, (_, k) => (first + k) * step);
  }

  class Axes {
    constructor({names, x, y, height}) {
      const wide = WIDTH - LEFT - RIGHT, high = Math.round(wide * height);
      Object.assign(this, {x, y, wide, high});
      this.svg = shape("svg", {viewBox: `0 0 ${WIDTH} ${high + TOP + BOTTOM}`});
      const plane = this.plane = shape("g", {transform: `translate(${LEFT} ${TOP})`}, this.svg);
      for (const value of ticks(x, 6)) {
        const at = this.across(value);
        shape("line", {class: value ? "grid" : "axis", x1: at, x2: at, y1: 0, y2: high}, plane);
        // the name of the axis stands at its right end
        if (at < wide - 12 - 8 * names[0].length) shape("text", {x: at, y: high + 15, "text-anchor": "middle", "aria-hidden": "true"}, plane, short(value));
      }
      // an axis without a name has no numbers: a track, a body
      for (const value of names[1] ? ticks(y, height > 0.6 ? 6 : 4) : []) {
        const at = this.up(value);
        shape("line", {class: value ? "grid" : "axis", y1: at, y2: at, x1: 0, x2: wide}, plane);
        shape("text", {x: -6, y: at + 4, "text-anchor": "end", "aria-hidden": "true"}, plane, short(value));
      }
      shape("text", {class: "name", x: wide, y: high + 17, "text-anchor": "end"}, plane, names[0]);
      shape("text", {class: "name", x: 0, y: -8}, plane, names[1]);
      // an SVG of its own clips what leaves the panel
      this.content = shape("svg", {width: wide, height: high}, plane);
      this.frame = shape("rect", {class: "frame", width: wide, height: high}, plane);
      this.handles = shape("g", {}, plane);
    }
    across(value) { return (value - this.x[0]) / (this.x[1] - this.x[0]) * this.wide; }
    up(value) { return (this.y[1] - value) / (this.y[1] - this.y[0]) * this.high; }
    /* A point in tenths of a unit; far outside it is moved to where no browser minds it. */
    at(x, y) {
      const near = (value) => Math.round(10 * Math.max(-5000, Math.min(5000, value))) / 10;
      return [near(this.across(x)), near(this.up(y))];
    }
    values(event) {
      const {x, y} = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.plane.getScreenCTM().inverse());
      return [this.x[0] + x / this.wide * (this.x[1] - this.x[0]), this.y[1] - y / this.high * (this.y[1] - this.y[0])];
    }
    path(points) {
      let text = "", open = false;
      for (const [x, y] of points) {
        if (!Number.isFinite(x + y)) { open = false; continue; }
        text += (open ? "L" : "M") + this.at(x, y).join(" ");
        open = true;
      }
      return text;
    }
  }

  /* The part of the panel where a condition holds, and its border: marching squares whose corners are moved onto the border by
     bisection. */
  function region(axes, holds) {
    const xs = Array.from({length: CELLS + 1}, (_, k) => axes.x[0] + (axes.x[1] - axes.x[0]) * k / CELLS);
    const ys = Array.from({length: CELLS + 1}, (_, k) => axes.y[0] + (axes.y[1] - axes.y[0]) * k / CELLS);
    const inside = ys.map((y) => xs.map((x) => Boolean(holds(x, y))));
    const cross = (a, b) => {  // a is inside, b is outside
      for (let n = 0; n < 12; n += 1) {
        const middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        if (holds(...middle)) a = middle; else b = middle;
      }
      return a;
    };
    let area = "", border = "";
    for (let j = 0; j < CELLS; j += 1) {
      let run = null;
      const close = (k) => {
        if (run !== null) area += axes.path([[xs[run], ys[j]], [xs[k], ys[j]], [xs[k], ys[j + 1]], [xs[run], ys[j + 1]]]) + "Z";
        run = null;
      };
      for (let k = 0; k < CELLS; k += 1) {
        const corners = [[k, j], [k + 1, j], [k + 1, j + 1], [k, j + 1]];
        const within = corners.map(([i, l]) => inside[l][i]);
        if (within.every(Boolean)) { run ??= k; continue; }
        close(k);
        if (!within.some(Boolean)) continue;
        const outline = [], crossings = [];
        corners.forEach(([i, l], n) => {
          const here = [xs[i], ys[l]], [i2, l2] = corners[(n + 1) % 4], next = [xs[i2], ys[l2]];
          if (within[n]) outline.push(here);
          if (within[n] !== within[(n + 1) % 4]) {
            const point = within[n] ? cross(here, next) : cross(next, here);
            outline.push(point);
            crossings.push(point);
          }
        });
        area += axes.path(outline) + "Z";
        for (let n = 0; n < crossings.length; n += 2) border += axes.path(crossings.slice(n, n + 2));
      }
      close(CELLS);
    }
    return {area, border};
  }

  function field(axes, rate) {
    const size = axes.wide / ARROWS * 0.4;
    let text = "";
    for (let py = axes.wide / ARROWS / 2; py < axes.high; py += axes.wide / ARROWS) {
      for (let px = axes.wide / ARROWS / 2; px < axes.wide; px += axes.wide / ARROWS) {
        const [u, w] = rate(axes.x[0] + px / axes.wide * (axes.x[1] - axes.x[0]), axes.y[1] - py / axes.high * (axes.y[1] - axes.y[0]));
        const a = u / (axes.x[1] - axes.x[0]) * axes.wide, b = -w / (axes.y[1] - axes.y[0]) * axes.high, length = Math.hypot(a, b);
        if (!length || !Number.isFinite(length)) continue;
        const [dx, dy] = [a / length * size, b / length * size], [x, y] = [px + dx, py + dy];
        const number = (value) => value.toFixed(1);
        text += `M${number(px - dx)} ${number(py - dy)}L${number(x)} ${number(y)}M${number(x - 0.6 * dx - 0.35 * dy)} ${number(y - 0.6 * dy + 0.35 * dx)}` +
                `L${number(x)} ${number(y)}L${number(x - 0.6 * dx + 0.35 * dy)} ${number(y - 0.6 * dy - 0.35 * dx)}`;
      }
    }
    return text;
  }

  const MARKS = {cross: "m-5 -5l10 10m0 -10l-10 10", dot: "m-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0", ring: "m-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0"};

  /* Each kind of part: makes its shapes, and returns what draws them anew. */
  const PARTS = {
    line(axes, part, figure) {
      const path = shape("path", {class: `line ${part.style}`}, axes.content);
      return () => set(path, {d: axes.path(figure.points(part))});
    },
    segments(axes, part, figure) {
      const path = shape("path", {class: `line ${part.style}`}, axes.content);
      return () => { const y = part.y(figure.v); set(path, {d: axes.path(part.x(figure.v).map((x, k) => [x, y[k]]))}); };
    },
    marks(axes, part, figure) {
      const path = shape("path", {class: `mark ${part.style}`}, axes.content);
      const visible = ([x, y]) => Number.isFinite(x + y);
      return () => set(path, {d: figure.points(part).filter(visible).map((point) => `M${axes.at(...point).join(" ")}${MARKS[part.style]}`).join("")});
    },
    region(axes, part, figure) {
      const area = shape("path", {class: "area"}, axes.content), border = shape("path", {class: "border"}, axes.content);
      return () => {
        const paths = region(axes, (x, y) => part.condition(figure.v, [x, y])[0]);
        set(area, {d: paths.area});
        set(border, {d: paths.border});
      };
    },
    field(axes, part, figure) {
      const path = shape("path", {class: "field"}, axes.content);
      return () => set(path, {d: field(axes, (x, y) => [part.x(figure.v, [x, y])[0], part.y(figure.v, [x, y])[0]])});
    },
    point(axes, part, figure) {
      const handle = shape("g", {class: part.moved ? "handle" : "point"}, part.moved ? axes.handles : axes.content);
      if (part.moved) {
        shape("circle", {class: "reach", r: 22}, handle);
        shape("circle", {class: "ring", r: 11}, handle);
        movable(axes, part, figure, handle);
      }
      shape("circle", {class: "disc", r: 6}, handle);
      return () => {
        const position = [part.x(figure.v)[0], part.y(figure.v)[0]];
        set(handle, {transform: `translate(${axes.at(...position).join(" ")})`});
        if (part.moved) {
          const named = part.moved.flatMap((k) => k === null ? [] : `${figure.parameters[k].name} = ${short(figure.inputs[k])}`);
          set(handle, {"aria-valuenow": position[0], "aria-valuetext": named.join(", ")});
        }
      };
    },
  };

  /* A point follows the pointer, a click into its panel, and the arrow keys (with Shift in small steps). */
  function movable(axes, part, figure, handle) {
    const limits = figure.parameters[part.moved.find((k) => k !== null)].limits;
    const names = part.moved.flatMap((k) => k === null ? [] : figure.parameters[k].label || figure.parameters[k].name);
    set(handle, {tabindex: 0, role: "slider", "aria-label": `${part.label || names.join(", ")}, moved by the arrow keys`,
                 "aria-valuemin": limits[0], "aria-valuemax": limits[1]});
    const move = (values) => figure.move(new Map(part.moved.flatMap((k, i) => k === null ? [] : [[k, values[i]]])));
    handle.addEventListener("pointerdown", (event) => {
      handle.setPointerCapture(event.pointerId);
      handle.focus({preventScroll: true});
      event.preventDefault();
    });
    for (const kind of ["pointermove", "pointerup"]) {
      handle.addEventListener(kind, (event) => { if (handle.hasPointerCapture(event.pointerId)) move(axes.values(event)); });
    }
    axes.frame.addEventListener("click", (event) => { if (axes.handles.childElementCount === 1) move(axes.values(event)); });
    handle.addEventListener("keydown", (event) => {
      const [i, sign] = {ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowDown: [1, -1], ArrowUp: [1, 1]}[event.key] || [];
      if (i === undefined || part.moved[i] === null) return;
      const range = i ? axes.y : axes.x, k = part.moved[i];
      figure.move(new Map([[k, figure.inputs[k] + sign * (range[1] - range[0]) / (event.shiftKey ? 400 : 40)]]));
      event.preventDefault();
    });
  }

  /* Figure ------------------------------------------------------------------------------------------------------------ */

  const ROLES = ["value", "rates", "slopes", "initial", "end", "updates", "low", "high", "coefficients", "x", "y", "condition"];
  const compiled = (entry) => ({...entry, ...Object.fromEntries(ROLES.flatMap((role) => typeof entry[role] === "string" ? [[role, compile(entry[role])]] : []))});

  class Figure {
    constructor(box) {
      const {description, parameters, steps, panels, sentences} = JSON.parse(box.dataset.explorer);
      Object.assign(this, {box, parameters, v: [], rows: [], drawn: []});
      this.inputs = parameters.map(({value}) => value);
      this.steps = steps.map(compiled);
      this.sentences = sentences.map((cases) => cases.map(([condition, pieces]) => [compile(condition), pieces]));
      const columns = tag("div", {className: "explorer-panels", role: "group", ariaLabel: description});
      this.panels = panels.map((panel) => {
        const axes = new Axes(panel), parts = panel.parts.map(compiled), legend = tag("ul", {className: "explorer-legend"});
        for (const part of parts) {
          this.drawn.push({uses: part.uses, draw: PARTS[part.kind](axes, part, this)});
          if (part.label) legend.append(this.entry(part));
        }
        const together = tag("div", {className: "explorer-panel"}, axes.svg);
        if (legend.childElementCount) together.append(legend);
        if (!panel.below) columns.append(tag("div", {className: "explorer-column"}));
        columns.lastElementChild.append(together);
        return {axes, parts};
      });
      this.controls = tag("div", {className: "explorer-controls"});
      this.reset = tag("button", {type: "button", textContent: "Reset"});
      this.sliders = parameters.map((parameter, k) => parameter.slider && this.slider(parameter, k));
      this.reset.addEventListener("click", () => this.move(new Map(parameters.map(({value}, k) => [k, value]))));
      this.words = tag("p", {className: "explorer-sentence", ariaLive: "polite"});
      box.append(columns, this.controls, tag("div", {className: "explorer-foot"}, this.words, this.reset));
      this.update(new Set(parameters.keys()));
      box.classList.add("ready");
    }

    slider({label, limits: [min, max], step, value, play}, k) {
      const output = tag("output"), input = tag("input", {type: "range"});
      Object.assign(input, {min, max, step, value});
      input.addEventListener("input", () => this.move(new Map([[k, Number(input.value)]])));
      this.controls.append(tag("label", {}, tag("span", {textContent: label}), input, output));
      if (play) this.controls.append(this.player(k, input));
      return {input, output};
    }

    /* A button that moves a slider to its end; with reduced motion it goes on by a twelfth. */
    player(k, input) {
      const {limits: [low, high], play} = this.parameters[k], still = matchMedia("(prefers-reduced-motion: reduce)");
      const button = tag("button", {type: "button"});
      let last = null;
      const stop = () => { last = null; name(); };
      const name = () => { button.textContent = still.matches ? "Next step" : last === null ? "Play" : "Pause"; };
      const advance = (share) => this.move(new Map([[k, this.inputs[k] >= high ? low : this.inputs[k] + share * (high - low)]]));
      const frame = (now) => {
        if (last === null) return;
        advance((now - last) / 1000 / play);
        last = now;
        if (this.inputs[k] < high) requestAnimationFrame(frame); else stop();
      };
      button.addEventListener("click", () => {
        if (still.matches) advance(1 / 12);
        else if (last !== null) stop();
        else {
          if (this.inputs[k] >= high) this.move(new Map([[k, low]]));
          last = performance.now();
          name();
          requestAnimationFrame(frame);
        }
      });
      input.addEventListener("input", stop);
      still.addEventListener("change", stop);
      this.reset.addEventListener("click", stop);
      name();
      return button;
    }

    entry(part) {
      const sample = shape("svg", {viewBox: "0 0 28 14", width: 28, height: 14, "aria-hidden": "true"});
      if (part.kind === "region") shape("rect", {class: "area border", x: 3, y: 1.5, width: 22, height: 11}, sample);
      else if (part.kind === "point") shape("circle", {class: "disc", cx: 14, cy: 7, r: 5}, shape("g", {class: part.moved ? "handle" : "point"}, sample));
      else if (part.kind === "marks") shape("path", {class: `mark ${part.style}`, d: `M14 7${MARKS[part.style]}`}, sample);
      else shape("path", {class: `line ${part.style}`, d: "M1 7H27"}, sample);
      return tag("li", {}, sample, part.label);
    }

    /* Set inputs, kept within their limits. */
    move(values) {
      const changed = new Set();
      for (const [k, value] of values) {
        const [low, high] = this.parameters[k].limits;
        this.inputs[k] = Math.max(low, Math.min(high, Number(value.toPrecision(6))));
        changed.add(k);
      }
      // what is read aloud waits until the reader pauses
      this.words.ariaBusy = "true";
      clearTimeout(this.pause);
      this.pause = setTimeout(() => { this.words.ariaBusy = "false"; }, 500);
      this.update(changed);
    }

    update(changed) {
      const concerned = ({uses}) => this.words.textContent === "" || uses.some((k) => changed.has(k));
      let scalar = 0, series = 0, input = 0;
      for (const step of this.steps) {
        if (step.kind in SERIES) {
          if (concerned(step)) this.rows[series] = SERIES[step.kind](step, this.v);
          series += 1;
        } else {
          if (step.kind === "parameter") this.v[scalar] = this.inputs[input++];
          else if (concerned(step)) this.v[scalar] = SCALARS[step.kind](step, this.v, this.rows);
          scalar += 1;
        }
      }
      for (const part of this.drawn) if (concerned(part)) part.draw();
      this.sliders.forEach((slider, k) => {
        if (!slider) return;
        slider.input.value = this.inputs[k];
        slider.output.value = short(this.inputs[k]);
        slider.input.ariaValueText = slider.output.value;
      });
      const written = this.sentences.map((cases) => cases.find(([condition]) => condition(this.v))[1]
        .map((piece) => typeof piece === "number" ? short(this.v[piece]) : piece).join("")).join(" ");
      if (written !== this.words.textContent) this.words.textContent = written || " ";
    }

    points({series, x, y}) { return this.rows[series].map((row) => [x(this.v, row)[0], y(this.v, row)[0]]); }
  }

  const start = () => document.querySelectorAll(".explorer[data-explorer]:not(.ready)").forEach((box) => { box.explorer = new Figure(box); });
  if (document.readyState === "loading") addEventListener("DOMContentLoaded", start); else start();
})();
