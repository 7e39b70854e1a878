"""Problems and their conditions in Markdown with LaTeX, as on a blackboard."""

import sympy as sp


def problem_markdown(problem):
    """Return a problem as a block of formulas."""
    lines = [rf"{_dot(y)} = {sp.latex(f)}" for y, f in problem.dynamics.items()]
    lines += [_bounds(u, *bounds) for u, bounds in problem.controls.items()]
    lines += [rf"{sp.latex(relation)}" for relation in problem.path]
    starts = [
        f"{sp.latex(y)}(0) = {sp.latex(v)}" for y, v in problem.initial.items() if v is not None
    ]
    free = [rf"{sp.latex(y)}(0)\ \text{{free}}" for y, v in problem.initial.items() if v is None]
    lines.append(r",\quad ".join(starts + free))
    if problem.terminal:
        lines.append(
            r",\quad ".join(f"{sp.latex(g)} = 0" for g in problem.terminal)
            + rf"\quad\text{{at}}\ t = {_end(problem)}"
        )
    if problem.terminal_inequalities:
        lines.append(
            r",\quad ".join(map(sp.latex, problem.terminal_inequalities))
            + rf"\quad\text{{at}}\ t = {_end(problem)}"
        )
    lines.append(rf"J = {_cost(problem)} \to \{'max' if problem.maximise else 'min'}")
    if isinstance(problem.duration, tuple):
        lines.append(
            rf"{sp.latex(problem.duration[0])} \le t_k \le {sp.latex(problem.duration[1])}"
        )
    return _block(lines)


def conditions_markdown(derived):
    """Return the conditions one after another, each under its name."""
    problem = derived.problem
    parts = [
        "**Pontryagin function**",
        _block([rf"H = {sp.latex(derived.hamiltonian)}"]),
        "**Adjoint system**",
        _block([rf"{_dot(psi)} = {sp.latex(rate)}" for psi, rate in derived.adjoint.items()]),
        "**Maximum of H over the admissible controls**",
        _block(_maximum(derived)),
    ]
    for u, slope in derived.switching.items():
        arc = derived.singular[u]
        parts.append(f"**Switching function of** ${sp.latex(u)}$ **and its derivatives**")
        derivatives = [rf"\frac{{\partial H}}{{\partial {sp.latex(u)}}} = {sp.latex(slope)}"]
        derivatives += [
            rf"\frac{{d{_power(k)}}}{{dt{_power(k)}}}\frac{{\partial H}}{{\partial {sp.latex(u)}}} "
            r"= "
            rf"{sp.latex(d)}"
            for k, d in enumerate(arc.derivatives[1:], 1)
        ]
        parts += [_block(derivatives), _singular(arc)]
    for constraint in derived.path:
        parts += _state_constraint(constraint)
    when = r"as $t \to \infty$" if problem.duration == sp.oo else "at $t_k$"
    parts.append(f"**Transversality** {when}")
    parts.append(_block([f"{sp.latex(e)} = 0" for e in derived.transversality]))
    for symbol, g in zip(
        derived.terminal_multipliers[len(problem.terminal) :], problem.end_constraints
    ):
        name = sp.latex(symbol)
        parts.append(rf"with ${name} \ge 0$, and ${name} = 0$ where ${sp.latex(g)} < 0$")
    if problem.terminal and not problem.end_constraints and derived.reduced_transversality:
        parts.append(
            "that is,\n" + _block([f"{sp.latex(e)} = 0" for e in derived.reduced_transversality])
        )
    if derived.initial_transversality:
        parts.append(
            "and at the start "
            + ", ".join(f"${sp.latex(psi)}(0) = 0$" for psi in derived.initial_transversality)
        )
    parts.append(
        "**Hamiltonian** "
        + (
            "$H = 0$ along the trajectory, since the final time is free."
            if problem.duration is None
            else "constant along the trajectory."
        )
    )
    parts.append(
        r"**Normal case** $\lambda_0 = 1$: "
        + f"$H = {sp.latex(derived.normal)}$. "
        + r"**Abnormal case** $\lambda_0 = 0$, $\psi \ne 0$: "
        + f"$H = {sp.latex(derived.abnormal)}$."
    )
    return "\n\n".join(parts)


def _maximum(derived):
    lines = []
    for u in derived.problem.control:
        best = derived.maximising[u]
        if best is None:
            lines.append(
                rf"{sp.latex(u)} = \arg\max H,\quad "
                rf"\frac{{\partial H}}{{\partial {sp.latex(u)}}} = "
                rf"{sp.latex(sp.diff(derived.hamiltonian, u))}"
            )
        elif u in derived.switching:
            pieces = [
                rf"{sp.latex(value)}, & {sp.latex(condition)}"
                for value, condition in best.args
                if value is not sp.nan
            ]
            lines.append(
                rf"{sp.latex(u)} = \begin{{cases}} " + r" \\ ".join(pieces) + r" \end{cases}"
            )
        else:
            lines.append(rf"{sp.latex(u)} = {sp.latex(best)}")
    return lines


def _singular(arc):
    u = sp.latex(arc.control_symbol)
    if arc.excluded:
        return r"No singular arc: these equations leave only $\psi = 0$, $\lambda_0 = 0$."
    if arc.order is None:
        return f"Singular arcs: no derivative of the switching function contains ${u}$."
    parts = [f"Singular arcs have order $q = {arc.order}$"]
    if arc.surface:
        parts.append("lie on " + ", ".join(f"${sp.latex(e)} = 0$" for e in arc.surface))
    if arc.control is not None:
        parts.append(rf"have the control ${u} = {sp.latex(arc.control)}$")
    if arc.kelley == 0:
        return (
            ", ".join(parts)
            + ", where the factor of the control vanishes: this derivative does not determine it."
        )
    kelley = sp.latex(arc.kelley)
    verdict = r"\le 0" if arc.kelley.is_nonpositive else r"> 0" if arc.kelley.is_positive else ""
    return (
        ", ".join(parts)
        + rf". Kelley: $(-1)^q b = {kelley} {verdict}$"
        + (
            ", as a minimum needs."
            if arc.kelley.is_nonpositive
            else ", which excludes a minimum with the control between its bounds."
            if arc.kelley.is_positive
            else r"; a minimum needs $\le 0$."
        )
    )


def _state_constraint(constraint):
    """Return the parts about one path constraint."""
    p, eta = constraint.order, sp.latex(constraint.multiplier)
    g = sp.latex(constraint.expression)
    parts = [
        rf"**State constraint** ${g} \le 0$ **of order $p = {p}$**",
        _block(
            [f"g = {g}"]
            + [
                rf"\frac{{d{_power(k)}g}}{{dt{_power(k)}}} = {sp.latex(d)}"
                for k, d in enumerate(constraint.derivatives[1:], 1)
            ]
        ),
        "On a boundary arc $g = 0$, with the multiplier $" + eta + r" \ge 0$:",
    ]
    lines = [rf"{sp.latex(u)} = {sp.latex(e)}" for u, e in constraint.boundary_control.items()]
    lines += [rf"{_dot(psi)} = {sp.latex(rate)}" for psi, rate in constraint.adjoint.items()]
    if constraint.density is not None:
        lines.append(rf"{eta} = {sp.latex(constraint.density)}")
    parts.append(_block(lines))
    names = ["g", r"\dot g"][: min(p, 2)] + [rf"g^{{({k})}}" for k in range(2, p)]
    entry = [f"{name} = 0" for name in names]
    entry += [f"{sp.latex(e)} = 0" for e in constraint.conditions]
    parts.append("where it begins:\n" + _block(entry))
    parts.append(
        r"The costate is continuous there and where the arc ends."
        if p == 1
        else r"There, where the arc ends, and where the trajectory touches the boundary ($g = \dot g = 0$): "
        r"$\psi(t+0) = \psi(t-0) + \nu\,\dfrac{\partial g}{\partial y}$ with $\nu \ge 0$; $H$ is continuous."
    )
    return parts


def _bounds(u, low, high):
    name = sp.latex(u)
    if low == -sp.oo and high == sp.oo:
        return rf"{name} \in \mathbb{{R}}"
    if low == -high:
        return rf"|{name}| \le {sp.latex(high)}"
    lower_side = "" if low == -sp.oo else rf"{sp.latex(low)} \le "
    return lower_side + name + ("" if high == sp.oo else rf" \le {sp.latex(high)}")


def _end(problem):
    return "t_k" if problem.free_time else sp.latex(problem.duration)


def _cost(problem):
    if problem.time_optimal:
        return "t_k"
    parts = (
        [] if problem.final == 0 else [sp.latex(problem.final) + rf"\Big|_{{t = {_end(problem)}}}"]
    )
    if problem.running != 0:
        density = sp.latex(problem.running)
        density = rf"\left({density}\right)" if problem.running.is_Add else density
        parts.append(rf"\int_0^{{{_end(problem)}}} {density}\,dt")
    return " + ".join(parts)


def _dot(symbol):
    letter, _, index = sp.latex(symbol).partition("_")
    return rf"\dot{{{letter}}}" + (f"_{index}" if index else "")


def _power(k):
    return "" if k == 1 else f"^{k}"


def _block(lines):
    return (
        "$$\n\\begin{aligned}\n"
        + " \\\\\n".join(f"& {line}" for line in lines)
        + "\n\\end{aligned}\n$$"
    )
