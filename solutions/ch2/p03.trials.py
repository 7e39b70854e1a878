# %% wrong
# Does one measurement give only one number? Think of its derivative. (hint 1)
a_observable = False
a_unobservable_states = [
    [0, 1]
]  # Are these the states with zero output at a single instant only? (hint 1)
# Is the position not determined by the velocity here? The body is not free. (hint 1)
b_observable = False
b_unobservable_states = [
    [1, 0]
]  # Are these the states with zero output at a single instant only? (hint 1)
c_observable = True  # Is it enough that both states enter the measurement? (hint 1)
c_unobservable_states = [[1, 1]]  # Is this the observable eigenvector? (hint 2)
c_unobservable_states = [[0, 0]]  # Can the zero vector belong to a basis? (hint 1)
d_observable = False  # Do imaginary eigenvalues make a motion unobservable? (hint 1)
d_unobservable_states = [[0, 1]]  # Does this motion really keep z at zero? (hint 1)
# Does one measurement give only one number? Think of its derivative. (hint 1)
e_observable = False
e_unobservable_states = [
    [1, 0]
]  # Are these the states with zero output at a single instant only? (hint 1)
f_observable = False  # The output is that of item c, but is the system? (hint 1)
f_unobservable_states = [[1, -1]]  # Does z stay zero on this line, or only at one instant? (hint 1)
g_observable = True  # Does a regular matrix make a system observable? (hint 1)
g_unobservable_states = [
    [0, 1]
]  # Is this the measured direction instead of the unobservable one? (hint 1)
# Does a double eigenvalue exclude observability? Count its eigenvectors. (hint 2)
h_observable = False
h_unobservable_states = [[1, -1]]  # Does z stay zero on this line, or only at one instant? (hint 1)
# Is it enough that both states enter the output? Look at how the two modes grow. (hint 1)
i_observable = True
i_unobservable_states = [[a, 1]]  # Was a sign lost? Substitute the vector into the output. (hint 1)
i_unobservable_states = [[1, -1 / a]]  # Is this vector defined where the divisor vanishes? (hint 2)

# %% right
a_unobservable_states = sp.zeros(2, 0)  # a matrix without columns
b_unobservable_states = sp.zeros(2, 0)  # a matrix without columns
d_unobservable_states = sp.zeros(2, 0)  # a matrix without columns
e_unobservable_states = sp.zeros(2, 0)  # a matrix without columns
f_unobservable_states = sp.zeros(2, 0)  # a matrix without columns
h_unobservable_states = sp.zeros(2, 0)  # a matrix without columns
c_unobservable_states = [(-2.5, 2.5)]  # another length and sign
c_unobservable_states = sp.Matrix([1, -1])  # a column
g_unobservable_states = [sp.Matrix([7, 0])]  # a list of columns
# floats
import numpy as np

g_unobservable_states = [np.array([1.0, 0.0])]
i_unobservable_states = [[-sp.Symbol("a"), 1]]  # the other sign, a plain symbol
i_unobservable_states = [[a * (1 + a**2), -1 - a**2]]  # a multiple that is never zero
