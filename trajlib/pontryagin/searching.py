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
        # A point is hard to hit by chance: begin with some way to it. A curve is crossed by most motions, each of which
        # may lead to an extremal of its own: there all of them are tried, and the way that needs little time as well.
        free = guess is None and numeric.duration is None
        ladder_first, every = free and numeric.m > 1, free and numeric.m == 1
        pictures = []
        for attempt in ("ladder", "guesses") if ladder_first else ("guesses", "ladder"):
            if attempt == "guesses":
                pictures += _successes(programme, starts, failures, every)
            elif numeric.m and not _runs_away(numeric, failures):
                start, distance = reach_target(numeric, structure, side)
                closest = min(closest, distance)
                pictures += _successes(programme, [start] if start else [], failures)
            if pictures and not every:
                break
        found += [(picture, side) for picture in pictures]
    if not found:
        explain(numeric, failures, closest, structure)
    return min(found, key=lambda pair: pair[0].cost)


def _successes(programme, starts, failures, every=False):
    """The pictures that the starts lead to: the first one, or every one; what fails is put to the failures."""
    pictures = []
    for start in starts:
        result = programme.solve(start)
        if not isinstance(result, Picture):
            failures.append(result)
            continue
        pictures.append(result)
        if not every:
            break
    return pictures


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
        raise Unbounded(f"the best duration tends to zero (it ran into {low:g}): the infimum "
                        f"{_cost(numeric, picture.cost)} is approached "
                        "by ever shorter processes and not attained. Bound the controls, or give a duration.")
    if T >= high*(1 - 1e-6) and not numeric.time_bounds_given:
        raise Unbounded(f"the best duration grows beyond every bound (it ran into {high:g}): there is no best "
                        f"process. Give a duration, or "
                        "bounds for it; for a process that ends when it first meets the target, state it with "
                        "first_return=True.")
    if numeric.time_bounds_given:
        for bound in (low, high):
            if abs(T - bound) <= 1e-6*(1 + bound):
                return bound
    return None


def refuse_endless(numeric, picture, side):
    """Raise `Unbounded` if more time never costs more: the infimum is approached as the duration grows."""
    from dataclasses import replace

    from .numeric import NumericProblem

    durations, costs = [], []
    for factor in (2, 1, 1/2, 1/4, 1/8):
        duration = factor*picture.duration
        fixed = NumericProblem(replace(numeric.problem, duration=duration))
        # Steps as long as those of the picture, so that the costs can be compared.
        programme = Transcription(fixed, int(np.ceil(factor*len(picture.controls))), side=side)
        result = programme.solve((duration, picture.states, picture.controls))
        if not isinstance(result, Picture) or (costs and result.cost < costs[-1] - 1e-6*abs(costs[-1])):
            break
        durations.append(duration)
        costs.append(result.cost)
    if len(costs) < 2:
        return
    values = ", ".join(f"{_cost(numeric, cost):.7g} for {duration:.3g}"
                       for duration, cost in zip(durations[::-1], costs[::-1]))
    raise Unbounded(f"no best duration was found: the cost keeps "
                    f"{'rising' if numeric.problem.maximise else 'falling'} with the duration "
                    f"({values}), towards about {_cost(numeric, costs[0]):.7g}. It seems that this value is "
                    f"approached as the duration "
                    "grows, and not attained. Give a duration.")


def explain(numeric, failures, closest, structure=None):
    """Raise the reason why no picture was found. `closest`: the least distance from the target, infinite if unknown."""
    failure = _runs_away(numeric, failures)
    if failure:
        raise Unbounded(f"the cost falls without bound (it passed {_cost(numeric, failure.cost):.3g}): there is no "
                        f"optimal process. "
                        "Check the sign of the cost, bound the controls, or fix the duration.")
    what = f" with the arcs {', '.join(map(name, structure))}" if structure else ""
    if 1e-4 < closest < np.inf:
        raise Infeasible(_infeasible_text(numeric, closest, what))
    raise NotConverged(f"IPOPT found no solution{what} from {len(failures)} guesses (last status: "
                       f"{failures[-1].status}). "
                       "Give a guess for the duration and the states, or look whether the problem has a solution at "
                       "all.")


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
        return (f"the duration {numeric.duration:g} is too short: the least time in which the target is reached is "
                f"{shortest:.6g}. " +
                text[0].upper() + text[1:] + ".")
    return text + f" in the given time {numeric.duration:g}. Try another duration, or a free one."


def _least_time(numeric):
    """The least time to the target, by transcription; None if none was found."""
    from dataclasses import replace

    from .numeric import NumericProblem

    fastest = NumericProblem(replace(numeric.problem, running=1, final=0, duration=None, maximise=False))
    pictures = _successes(Transcription(fastest, INTERVALS), guesses(fastest, INTERVALS), [])
    return pictures[0].duration if pictures else None


def _cost(numeric, value):
    return -value if numeric.problem.maximise else value
