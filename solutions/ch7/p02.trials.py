# %% wrong
a_unseen = [x, y, 0, 0]  # a displacement along the first line of sight
a_unseen = [0, 0, u, w]  # a change of velocity along the course
a_unseen = [-y, x, -w, u]  # across the line of sight, where the bearing sees best
b_condition = sp.Or(sp.Ne(p, 0), sp.Ne(q, 0))  # any manoeuvre
b_condition = sp.Ne(p*y - q*x, 0)  # the turn compared with the first line of sight
b_condition = sp.And(sp.Ne(p*(y + w*t) - q*(x + u*t), 0), sp.Ne(p, 0))  # as if a turn needed a part along x
b_condition = sp.Eq(p*(x + u*t) + q*(y + w*t), 0)  # perpendicular to the line of sight, instead of not along it
# the range before the turn instead of that at the moment of the bearing
c_error = delta*((x + u*t)**2 + (y + w*t)**2)/((t - T)*sp.Abs(p*(y + w*t) - q*(x + u*t)))
# the change of velocity instead of the way aside
c_error = delta*((x + u*t - p*(t - T))**2 + (y + w*t - q*(t - T))**2)/sp.Abs(p*(y + w*t) - q*(x + u*t))
# the sensitivity instead of the error
c_error = delta*(t - T)*sp.Abs(p*(y + w*t) - q*(x + u*t))/((x + u*t - p*(t - T))**2 + (y + w*t - q*(t - T))**2)
# without the absolute value
c_error = delta*((x + u*t - p*(t - T))**2 + (y + w*t - q*(t - T))**2)/((t - T)*(p*(y + w*t) - q*(x + u*t)))

# %% right
a_unseen = sp.Matrix([-x, -y, -u, -w])/3  # towards the observer, as a column
b_condition = sp.Ne((t - T)*(q*x + q*u*t - p*y - p*w*t), 0)  # multiplied out, with the time after the turn
b_condition = (p*(y + w*t) - q*(x + u*t))**2 > 0  # by the square
# by the way aside
cx, cy = p*(t - T), q*(t - T)
c_error = delta*((x + u*t - cx)**2 + (y + w*t - cy)**2)/sp.Abs(cx*(y + w*t) - cy*(x + u*t))
# by the cross product with the place at the moment of the bearing
rx, ry = x + u*t - p*(t - T), y + w*t - q*(t - T)
c_error = delta*(rx**2 + ry**2)/sp.Abs(rx*(y + w*t) - ry*(x + u*t))
