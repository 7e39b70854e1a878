# %% wrong
frozen = 1 - omega  # the derivative of H taken along, which is the other test
frozen = sp.sin(omega*t)**2 - sp.cos(omega*t)**2  # a sign lost in the second row
output = x10*sp.sin((omega + 1)*t) + x20*sp.cos((omega + 1)*t)  # the oscillator thought to turn the other way
output = x10*sp.sin(omega*t) + x20*sp.cos(omega*t)  # the state taken to stay where it was
output = x10*sp.cos((omega - 1)*t) + x20*sp.sin((omega - 1)*t)  # the two starts interchanged
rows = sp.Matrix.vstack(H, H*A)  # the frozen rows H and HA
rows = sp.Matrix.vstack(H, H.diff(t))  # the motion left out of the derivative
rows = sp.Matrix.vstack(H, H.diff(t) - H*A)  # the derivative with the wrong sign of the motion
gramian = sp.pi*sp.eye(2)  # as if the interval held whole periods of z
# the mean in the place of the integral
s, c = sp.sin(4*sp.pi*omega), 1 - sp.cos(4*sp.pi*omega)
gramian = sp.eye(2)/2 + sp.Matrix([[-s, c], [c, s]])/(8*sp.pi*(omega - 1))
region = sp.true  # the verdict of the frozen test
region = sp.And(sp.Ne(omega, 1), sp.Ne(omega, -1))  # both resonances, as if the direction of turning did not matter
region = sp.Ne(omega, -1)  # the oscillator thought to turn the other way
region = sp.And(sp.Ne(omega, 0), sp.Ne(omega, 1))  # an instrument at rest thought to see nothing
unseen = {1: [[0, 1]]}  # what is seen, in the place of what is not
unseen = {}  # the frozen test: nothing is ever unseen
unseen = {1: [[1, 0], [0, 1]]}  # both coordinates
unseen = {1: [[1, 0]], -1: [[1, 0]]}  # both resonances
# the instrument alone, with the state held fast
s, c = sp.sin(4*sp.pi*omega), 1 - sp.cos(4*sp.pi*omega)
gramian = sp.pi*sp.eye(2) + sp.Matrix([[-s, c], [c, s]])/(4*omega)

# %% right
frozen = sp.sin(omega*t)**2 + sp.cos(omega*t)**2  # not simplified
output = sp.sqrt(x10**2 + x20**2)*sp.cos((omega - 1)*t - sp.atan2(x10, x20))  # amplitude and phase
# as it comes, products of sines and cosines
output = (x10*sp.cos(t) + x20*sp.sin(t))*sp.sin(omega*t) + (x20*sp.cos(t) - x10*sp.sin(t))*sp.cos(omega*t)
# the double angles written out
s, c = sp.sin(4*sp.pi*omega), 1 - sp.cos(4*sp.pi*omega)
gramian = sp.pi*sp.eye(2) + sp.Matrix([[-s, c], [c, s]])/(4*omega - 4)
# nested lists, a Piecewise with the limit
first = sp.Piecewise((0, sp.Eq(omega, 1)), (sp.pi - sp.sin(4*sp.pi*omega)/(4*omega - 4), True))
mixed = sp.sin(2*sp.pi*omega)**2/(2*omega - 2)
gramian = [[first, mixed], [mixed, 2*sp.pi - first]]
region = sp.Or(omega < 1, omega > 1)  # two half-lines
region = sp.Ne(1 - omega, 0)  # the determinant of the derivative rows
unseen = {1: [sp.Matrix([-2, 0])]}  # another multiple, as a column
unseen = {1.0: [0.5, 0.0]}  # floats, without the outer list
