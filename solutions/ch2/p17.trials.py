# %% wrong
frozen = 1 - omega  # Was H differentiated as well? The frozen test takes it as constant. (hint 1)
# Was a sign lost in the second row? (hint 1)
frozen = sp.sin(omega * t) ** 2 - sp.cos(omega * t) ** 2
# Does the oscillator turn this way? (hint 1)
output = x10 * sp.sin((omega + 1) * t) + x20 * sp.cos((omega + 1) * t)
# Is the state constant? (hint 1)
output = x10 * sp.sin(omega * t) + x20 * sp.cos(omega * t)
# Were the two initial values swapped? (hint 2)
output = x10 * sp.cos((omega - 1) * t) + x20 * sp.sin((omega - 1) * t)
# Are these the frozen rows? The instrument turns too. (hint 2)
rows = sp.Matrix.vstack(H, H * A)
rows = sp.Matrix.vstack(H, H.diff(t))  # Was the motion left out of the derivative? (hint 2)
# What is the sign of the part of the motion in the derivative? (hint 2)
rows = sp.Matrix.vstack(H, H.diff(t) - H * A)
# Does the interval contain whole periods of $z$ for every $\omega$? (hint 2)
gramian = sp.pi * sp.eye(2)
# Is this the mean instead of the integral? (hint 1)
s, c = sp.sin(4 * sp.pi * omega), 1 - sp.cos(4 * sp.pi * omega)
gramian = sp.eye(2) / 2 + sp.Matrix([[-s, c], [c, s]]) / (8 * sp.pi * (omega - 1))
region = sp.true  # Is this the verdict of the frozen test? (hint 2)
# Does it matter in which direction the instrument turns? (hint 1)
region = sp.And(sp.Ne(omega, 1), sp.Ne(omega, -1))
region = sp.Ne(omega, -1)  # Does the oscillator turn this way? (hint 1)
# Is a moving state unobservable with a fixed instrument? (hint 1)
region = sp.And(sp.Ne(omega, 0), sp.Ne(omega, 1))
unobservable_states = {
    1: [[0, 1]]
}  # Is this the observable direction instead of the unobservable one? (hint 1)
unobservable_states = {}  # Is this the verdict of the frozen test? (hint 2)
unobservable_states = {1: [[1, 0], [0, 1]]}  # Are both coordinates unobservable? (hint 1)
# Does it matter in which direction the instrument turns? (hint 2)
unobservable_states = {1: [[1, 0]], -1: [[1, 0]]}
# Was the state kept constant here, so that only the instrument moves? (hint 1)
s, c = sp.sin(4 * sp.pi * omega), 1 - sp.cos(4 * sp.pi * omega)
gramian = sp.pi * sp.eye(2) + sp.Matrix([[-s, c], [c, s]]) / (4 * omega)

# %% right
frozen = sp.sin(omega * t) ** 2 + sp.cos(omega * t) ** 2  # not simplified
# amplitude and phase
output = sp.sqrt(x10**2 + x20**2) * sp.cos((omega - 1) * t - sp.atan2(x10, x20))
# as it comes, products of sines and cosines
output = (x10 * sp.cos(t) + x20 * sp.sin(t)) * sp.sin(omega * t) + (
    x20 * sp.cos(t) - x10 * sp.sin(t)
) * sp.cos(omega * t)
# the double angles written out
s, c = sp.sin(4 * sp.pi * omega), 1 - sp.cos(4 * sp.pi * omega)
gramian = sp.pi * sp.eye(2) + sp.Matrix([[-s, c], [c, s]]) / (4 * omega - 4)
# nested lists, a Piecewise with the limit
first = sp.Piecewise(
    (0, sp.Eq(omega, 1)), (sp.pi - sp.sin(4 * sp.pi * omega) / (4 * omega - 4), True)
)
mixed = sp.sin(2 * sp.pi * omega) ** 2 / (2 * omega - 2)
gramian = [[first, mixed], [mixed, 2 * sp.pi - first]]
region = sp.Or(omega < 1, omega > 1)  # two half-lines
region = sp.Ne(1 - omega, 0)  # the determinant of the derivative rows
unobservable_states = {1: [sp.Matrix([-2, 0])]}  # another multiple, as a column
unobservable_states = {1.0: [0.5, 0.0]}  # floats, without the outer list
