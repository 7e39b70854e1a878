"""From a statement to a discrete picture of an extremal, or to the reason why there is none."""
import numpy as np

from .errors import Infeasible, NotConverged, Unbounded
from .guesses import guesses, refuse_start_on_target, sides
from .structure import name
from .transcription import Picture, Transcription

INTERVALS = 80


def first_picture(numeric, guess=None, structure=None):
    """(picture, side): the best picture over the sides of the target. Raises what `explain` finds if there is none."""
    refuse_start_on_target(numeric)
    found, failures, closest = [], [], np.inf
    for side in sides(numeric):
        programme = Transcription(numeric, INTERVALS, structure, side)
        starts = [guess] if guess is not None else guesses(numeric, INTERVALS, side)
        # A point is hard to hit by chance: begin with some way to it. A curve is crossed by most motions.
        ladder_first = guess is None and numeric.m > 1 and numeric.duration is None
        picture = None
        for attempt in ("ladder", "guesses") if ladder_first else ("guesses", "ladder"):
            if attempt == "guesses":
                picture = _first_success(programme, starts, failures)
            elif numeric.m and not _runs_away(numeric, failures):
                start, distance = reach_target(numeric, structure, side)
                closest = min(closest, distance)
                picture = _first_success(programme, [start] if start else [], failures)
            if picture is not None:
                break
        if picture is not None:
            found.append((picture, side))
    if not found:
        explain(numeric, failures, closest, structure)
    return min(found, key=lambda pair: pair[0].cost)


def _first_success(programme, starts, failures):
    for start in starts:
        result = programme.solve(start)
        if isinstance(result, Picture):
            return result
        failures.append(result)
    return None


def reach_target(numeric, structure=None, side=None):
    """(guess, distance): a process that ends on the target, or None and the least distance |phi| found.

    A free duration is fixed at one trial value after another, up and down a ladder: with it the search is convex for a
    linear system, and finds a way if there is one.
    """
    programme = Transcription(numeric, INTERVALS//3, structure, side, distance_only=True)
    _, states, controls = next(iter(guesses(numeric, INTERVALS, side)))
    best, closest = None, np.inf

    def reached(duration):
        nonlocal best, closest
        if numeric.duration is None and not numeric.shortest <= duration <= numeric.longest:
            return False
        result = programme.solve((duration, states, controls), duration)
        if not isinstance(result, Picture):
            return False
        distance = float(np.sqrt(max(result.cost, 0.0)))
        closest = min(closest, distance)
        if distance < 1e-4:
            best = (duration, result.states, result.controls)
        return distance < 1e-4

    if numeric.duration is not None:
        reached(numeric.duration)
        return best, closest
    if reached(1.0):
        for duration in (0.25, 0.06):
            if not reached(duration):
                break
    else:
        duration = next((d for d in (2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 0.25) if reached(d)), None)
        if duration is not None and duration > 2:
            reached(duration/np.sqrt(2))
    if closest < np.inf and not np.isnan(numeric.start).any():
        # The start itself may be the closest of all.
        closest = min(closest, float(np.linalg.norm(numeric.target_value(numeric.start)[0].full())))
    return best, closest


def finer_picture(numeric, picture, side, factor):
    """The picture on a grid that is finer by a factor, or None."""
    programme = Transcription(numeric, factor*INTERVALS, side=side)
    result = programme.solve((picture.duration, picture.states, picture.controls))
    return result if isinstance(result, Picture) else None


def settled_duration(numeric, picture):
    """The duration if it is given, or if the best one lies at the user's bound; None if it is free inside.

    Raises `Unbounded` where a free duration ran into the bounds that it has by default.
    """
    if numeric.duration is not None:
        return numeric.duration
    T, low, high = picture.duration, numeric.shortest, numeric.longest
    if T <= 10*low and not numeric.time_bounds_given:
        raise Unbounded(f"the best duration tends to zero (it ran into {low:g}): the infimum {_cost(numeric, picture.cost)} is approached "
                        "by ever shorter processes and not attained. Bound the controls, or give a duration.")
    if T >= high*(1 - 1e-6) and not numeric.time_bounds_given:
        raise Unbounded(f"the best duration grows beyond every bound (it ran into {high:g}): there is no best process. Give a duration, or "
                        "bounds for it; for a process that ends when it first meets the target, state it with first_return=True.")
    if numeric.time_bounds_given:
        for bound in (low, high):
            if abs(T - bound) <= 1e-6*(1 + bound):
                return bound
    return None


def refuse_endless(numeric, picture, side):
    """Raise `Unbounded` if twice the time costs no more: the infimum is approached as the duration grows."""
    from dataclasses import replace

    from .numeric import NumericProblem

    longer = NumericProblem(replace(numeric.problem, duration=2*picture.duration))
    result = Transcription(longer, 2*len(picture.controls), side=side).solve((2*picture.duration, picture.states, picture.controls))
    if isinstance(result, Picture) and result.cost <= picture.cost + 1e-6*abs(picture.cost):
        raise Unbounded(f"no duration is best: with twice the time {picture.duration:.4g} the cost is "
                        f"{_cost(numeric, result.cost):.9g}, not worse than {_cost(numeric, picture.cost):.9g}. "
                        "The infimum is approached as the duration grows; give a duration.")


def explain(numeric, failures, closest, structure=None):
    """Raise the reason why no picture was found. `closest`: the least distance from the target, infinite if unknown."""
    failure = _runs_away(numeric, failures)
    if failure:
        raise Unbounded(f"the cost falls without bound (it passed {_cost(numeric, failure.cost):.3g}): there is no optimal process. "
                        "Check the sign of the cost, bound the controls, or fix the duration.")
    what = f" with the arcs {', '.join(map(name, structure))}" if structure else ""
    if 1e-4 < closest < np.inf:
        raise Infeasible(_infeasible_text(numeric, closest, what))
    raise NotConverged(f"IPOPT found no solution{what} from {len(failures)} guesses (last status: {failures[-1].status}). "
                       "Give a guess for the duration and the states, or look whether the problem has a solution at all.")


def _runs_away(numeric, failures):
    """The failure in which the cost fell without bound, if there is one."""
    for failure in failures:
        large = failure.cost < -1e8 or failure.largest_state > 1e12
        if failure.status == "Diverging_Iterates" or (large and failure.status == "Maximum_Iterations_Exceeded"):
            return failure
    return None


def _infeasible_text(numeric, closest, what):
    text = (f"no admissible control{what} leads to the target: the terminal equations are missed by {closest:.3g} "
            "at least (least distance found, by local search)")
    if numeric.duration is None or what:
        return text + ". The target cannot be reached from this start, or the bounds of the controls are too narrow."
    shortest = _least_time(numeric)
    if shortest is not None and shortest > numeric.duration:
        return (f"the duration {numeric.duration:g} is too short: the least time in which the target is reached is {shortest:.6g}. " +
                text[0].upper() + text[1:] + ".")
    return text + f" in the given time {numeric.duration:g}. Try another duration, or a free one."


def _least_time(numeric):
    """The least time to the target, by transcription; None if none was found."""
    from dataclasses import replace

    from .numeric import NumericProblem

    fastest = NumericProblem(replace(numeric.problem, running=1, final=0, duration=None, maximise=False))
    picture = _first_success(Transcription(fastest, INTERVALS), guesses(fastest, INTERVALS), [])
    return picture and picture.duration


def _cost(numeric, value):
    return -value if numeric.problem.maximise else value
