# %% wrong
a_unobservable_change = [x, y, 0, 0]  # Is the line of sight constant? (hint 1)
# Is a displacement unobservable along the course, or along the line of sight? (hint 1)
a_unobservable_change = [0, 0, u, w]
# Is this displacement across the line of sight, where a bearing changes most? (hint 1)
a_unobservable_change = [-y, x, -w, u]
# Is any manoeuvre enough? In which direction are all targets of the family displaced? (hint 1)
b_condition = sp.Or(sp.Ne(p, 0), sp.Ne(q, 0))
# Is the turn compared with the line of sight at the right instant? (hint 2)
b_condition = sp.Ne(p * y - q * x, 0)
# Must the turn have a component along x? (hint 2)
b_condition = sp.And(sp.Ne(p * (y + w * t) - q * (x + u * t), 0), sp.Ne(p, 0))
# Must it be perpendicular to the line of sight, or just not parallel to it? (hint 2)
b_condition = sp.Eq(p * (x + u * t) + q * (y + w * t), 0)
# At which instant does the range enter, before the turn or at the bearing? (hint 2)
c_error = (
    delta
    * ((x + u * t) ** 2 + (y + w * t) ** 2)
    / ((t - T) * sp.Abs(p * (y + w * t) - q * (x + u * t)))
)
# Is this the change of velocity instead of the displacement? (hint 1)
c_error = (
    delta
    * ((x + u * t - p * (t - T)) ** 2 + (y + w * t - q * (t - T)) ** 2)
    / sp.Abs(p * (y + w * t) - q * (x + u * t))
)
# Is this the sensitivity instead of the error? (hint 1)
c_error = (
    delta
    * (t - T)
    * sp.Abs(p * (y + w * t) - q * (x + u * t))
    / ((x + u * t - p * (t - T)) ** 2 + (y + w * t - q * (t - T)) ** 2)
)
# Can the size of an error be negative?
c_error = (
    delta
    * ((x + u * t - p * (t - T)) ** 2 + (y + w * t - q * (t - T)) ** 2)
    / ((t - T) * (p * (y + w * t) - q * (x + u * t)))
)

# %% right
a_unobservable_change = sp.Matrix([-x, -y, -u, -w]) / 3  # towards the observer, as a column
# multiplied out, with the time after the turn
b_condition = sp.Ne((t - T) * (q * x + q * u * t - p * y - p * w * t), 0)
b_condition = (p * (y + w * t) - q * (x + u * t)) ** 2 > 0  # by the square
# by the displacement
cx, cy = p * (t - T), q * (t - T)
c_error = (
    delta
    * ((x + u * t - cx) ** 2 + (y + w * t - cy) ** 2)
    / sp.Abs(cx * (y + w * t) - cy * (x + u * t))
)
# by the cross product with the position at the time of the bearing
rx, ry = x + u * t - p * (t - T), y + w * t - q * (t - T)
c_error = delta * (rx**2 + ry**2) / sp.Abs(rx * (y + w * t) - ry * (x + u * t))
