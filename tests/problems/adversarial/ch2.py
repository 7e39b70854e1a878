"""Chapter 2: observability and controllability."""

from adversarial import right, wrong

ROWS = [
    wrong("2.1", "a_transformation", "[[2, 0], [2, 2]]", "z is the first coordinate itself"),
    wrong("2.1", "b_canonical", "[[0, 1, 0], [0, 0, 1], [2, 2, 0]]", "the controllable form"),
    wrong("2.1", "b_transformation", "[[1, 0, 0], [0, 1, 0], [1, 1, 1]]", "Kalman's rows"),
    right("2.1", "a_transformation", "sp.Matrix([[1, 0], [-1, 1]]).inv()", "as an inverse"),
    wrong("2.2", "possible", "sp.Ne(alpha**2, 4)", "alpha = -2 is possible"),
    wrong("2.2", "possible", "sp.Ne(alpha, 2.01)", "the value is 2 exactly"),
    wrong("2.2", "unobservable_states", "{2: [[1, -1], [-2, 2]]}", "two multiples are no basis"),
    wrong("2.2", "transformation", "[[1, 1], [alpha, 2]]", "Kalman's rows"),
    right("2.2", "possible", "sp.Complement(sp.S.Reals, sp.FiniteSet(2))", "the set of the others"),
    right("2.2", "possible", "sp.Abs(alpha - 2) > 0", "a distance from 2"),
    right(
        "2.2",
        "unobservable_states",
        "{2: sp.Matrix([[1, -1]])}",
        "a row instead of a list of lists",
    ),
    wrong("2.3", "i_unobservable_states", "[[a**2, -a]]", "for a = 0 this is the zero vector"),
    wrong(
        "2.3", "i_unobservable_states", "[[a*(a - 7), 7 - a]]", "for a = 7 this is the zero vector"
    ),
    right(
        "2.3", "i_unobservable_states", "[[a*sp.exp(a), -sp.exp(a)]]", "the factor vanishes nowhere"
    ),
    right(
        "2.3",
        "i_unobservable_states",
        "[[-a/(1 + a**2), 1/(1 + a**2)]]",
        "the denominator vanishes nowhere",
    ),
    wrong(
        "2.4",
        "a_observable",
        "sp.And(sp.Ne(alpha - beta, 1), sp.Ne(alpha, 0))",
        "alpha = beta = 0 is observable",
    ),
    wrong("2.4", "a_observable", "sp.Ne(alpha**2, (beta + 1)**2)", "squaring adds a line"),
    wrong("2.4", "b_unobservable", "sp.And(h >= 1, h <= 2)", "between the roots it is observable"),
    wrong(
        "2.4",
        "b_unobservable_states",
        "{1: [[1, -1]], 2: [[1, -2]], 0: [[1, 0]]}",
        "for h = 0 it is observable",
    ),
    right("2.4", "b_unobservable", "sp.Eq(sp.Abs(h - 1.5), 0.5)", "half a unit from the middle"),
    right("2.4", "b_unobservable", "np.array([2.0, 1.0])", "the roots as an array"),
    right("2.4", "a_observable", "sp.Abs(alpha - beta - 1) > 0", "the resultant by its modulus"),
    wrong(
        "2.5",
        "g_unobservable_states",
        "{-1: [[0, 1, 0], [1, 0, 1], [1, 1, 1]], sp.Rational(1, 5): [[-1, 3, 5]]}",
        "the third one is the sum of the others",
    ),
    wrong("2.5", "j_region", "sp.Ne(alpha**2, 1)", "alpha = 1 is observable"),
    wrong("2.5", "g_region", "sp.And(sp.Ne(alpha, -1), sp.Ne(alpha, 0.21))", "the root is 1/5"),
    right("2.5", "h_region", "sp.Ne(alpha**3, -8)", "the only real cube root"),
    right(
        "2.5",
        "g_unobservable_states",
        "{-1: [[0, 2, 0], [1, 5, 1]], 0.2: [[-0.2, 0.6, 1]]}",
        "another basis, decimals",
    ),
    wrong("2.6", "b_unobservable_states", "[[Omega - r0, 0, 0, 0]]", "zero where Omega = r0"),
    wrong(
        "2.6",
        "d_unobservable_states",
        "[[1, 0, 0, 0], [0, 2*r0*(Omega - 1), -3*Omega*(Omega - 1), 0]]",
        "zero for Omega = 1",
    ),
    right("2.6", "d_unobservable_eigenvalues", "[0, 0]", "the double root named twice"),
    right(
        "2.6",
        "d_unobservable_states",
        "[[1, 0, 0, 0], [Omega, 2*sp.sqrt(r0/Omega), -3*sp.sqrt(Omega/r0), 0]]",
        "divided by the positive sqrt(r0 Omega)",
    ),
    wrong("2.7", "a_roots", "[1j, -1j, 0.58, -0.58]", "two digits: 0.577"),
    wrong("2.7", "a_roots", "[-1, sp.Rational(1, 3)]", "the squares of the roots"),
    wrong("2.7", "b_unobservable_eigenvalues", "[sp.sqrt(3)]", "the opposite root is lost too"),
    wrong(
        "2.7", "b_unobservable_states", "[[3, -1, 3*sp.sqrt(3), -sp.sqrt(3)]]", "one motion of two"
    ),
    wrong("2.7", "c_unobservable_eigenvalues", "[0, -1]", "the motion of the root 0 is seen"),
    wrong(
        "2.7",
        "d_unobservable_states",
        "[[2, -1, 0, 0], [0, 0, 2, -1]]",
        "only the falling motion is unseen",
    ),
    right("2.7", "a_roots", "np.roots([3, 0, 2, 0, -1])", "as NumPy does"),
    right(
        "2.7",
        "b_unobservable_states",
        "[[3, -1, 0, 0], [0, 0, 3, -1]]",
        "positions and velocities apart",
    ),
    right("2.7", "c_roots", "[0, 0, 1, -1]", "the double root twice"),
    wrong("2.8", "split", "[[l, l], [1, -1]]", "singular for l = 0"),
    wrong("2.8", "split", "[[1, 1], [l, 1 - l]]", "singular for l = 1/2"),
    wrong("2.8", "split", "[[1, 1], [l, l]]", "the second row is a multiple of the first"),
    wrong(
        "2.8",
        "split_system",
        "[sp.diag(l, l), sp.Matrix([[l, 0]])]",
        "for l = 0 nothing would be measured",
    ),
    wrong("2.8", "region", "sp.Ne(l1*(l1 - l2), 0)", "l1 = 0 is no exception"),
    right("2.8", "split", "[[1, 1], [l, l + 1]]", "the determinant is 1"),
    right("2.8", "split", "[[sp.exp(l), sp.exp(l)], [1, 0]]", "the exponential vanishes nowhere"),
    right(
        "2.8", "split_system", "[sp.diag(l, l), sp.Matrix([[1 + l**2, 0]])]", "xi = z/(1 + l**2)"
    ),
    right("2.8", "region", "sp.Ne(l1**3, l2**3)", "the cube is monotonic"),
    right("2.8", "region", "sp.Ne(sp.exp(l1), sp.exp(l2))", "the exponential is monotonic"),
    wrong(
        "2.9",
        "b_region",
        "sp.Ne((k - p + 1)*(k - 2*p + 4)*(p - 3), 0)",
        "p = 3, k = 100 is observable",
    ),
    wrong(
        "2.9",
        "c_unobservable_states",
        "[[q*(q - s), 0, -2*(q - s), -2*q*(q - s)]]",
        "zero where q = s",
    ),
    right(
        "2.9",
        "c_unobservable_states",
        "[[sp.sqrt(q), 0, -2/sp.sqrt(q), -2*sp.sqrt(q)]]",
        "divided by the root of q",
    ),
    right(
        "2.9", "b_region", "(k - p + 1)**2*(k - 2*p + 4)**2 > 0", "a square that does not vanish"
    ),
    wrong("2.10", "unobservable_states", "[[1, 0, 1], [-1, 0, -1]]", "twice the same direction"),
    wrong("2.10", "canonical_coordinates", "[[0, 1, 0], [1, 1, -1], [0, 0, 0]]", "a row too many"),
    wrong("2.10", "canonical", "[[[0, 1], [2.02, 0]], [[1, 0]]]", "one per cent off"),
    wrong(
        "2.10",
        "split_system",
        "[[[0, 1, 0], [2, 0, 0], [1, 0, 0.01]], [[1, 0, 0]]]",
        "the last eigenvalue is 0",
    ),
    right("2.10", "split", "[[0, 1, 0], [1, 7, -1], [0, 0, 1]]", "other rows of the same space"),
    wrong(
        "2.11",
        "a_split",
        "[[1, 0, 1], [0, 1, 0], [1, 0, -1]]",
        "the unobservable coordinate stands first",
    ),
    wrong("2.11", "b_split", "[[0, 1, 0], [1, 1, 1.01], [0, 0, 1]]", "one per cent off"),
    wrong("2.11", "c_unobservable_states", "[[-1, 1, 1.01]]", "one per cent off"),
    wrong("2.11", "d_unobservable_states", "[[1, -1, -1], [-1, 1, 1]]", "twice the same direction"),
    wrong(
        "2.11",
        "h_split",
        "[[-1, 1, -1], [1, -1, 3], [1, -1, 0]]",
        "the last row follows from the others",
    ),
    right(
        "2.11", "g_split", "[[1, 0, -1], [5, 1, -5], [0, 0, -2]]", "other rows of the same space"
    ),
    right("2.11", "h_split", "[[1, -1, 0], [0, 0, 1], [1, 0, 0]]", "simple rows of the same space"),
    wrong(
        "2.12",
        "a_split_system",
        "[[[2, 1, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1.01]], [[1, 0, 1, 0]]]",
        "the eigenvalue of eta is 1",
    ),
    wrong(
        "2.12",
        "a_split_system",
        "[sp.diag(sp.Matrix([[2, 1], [0, 2]]), 1, 1), [[1, 0, 1, 0]]]",
        "a Jordan block is lost",
    ),
    wrong(
        "2.12",
        "b_split_system",
        "[[[3, 0, 2, 0], [1, 3, 0, 0], [0, 0, 0, 0], [0, 0, 1, 2.02]], [[0, 1, 1, 0]]]",
        "one per cent off",
    ),
    wrong(
        "2.12",
        "c_split",
        "[[1, 1, 0, 0], [0, 0, 1, 1], [-1, 1, 0, 0], [0, 0, 1, 1]]",
        "a row stands twice",
    ),
    right(
        "2.12",
        "a_split_system",
        "[[[2, 1, 0, 0], [0, 2, 0, 0], [0, 0, 1, 0], [7, 5, 0.01, 1]], [[1, 0, 1, 0]]]",
        "eta may be driven by all of xi",
    ),
    right(
        "2.12",
        "a_split_system",
        "[[[0, 1, 0, 0], [0, 0, 1, 0], [4, -8, 5, 0], [0, 0, 1, 1]], [1, 0, 0, 0]]",
        "the observable part by z and its derivatives",
    ),
    right(
        "2.12",
        "c_split_system",
        "(lambda T: [T*c_matrix*T.inv(), np.array([0.5, 0, 0, 0])])(sp.Matrix([[1, 1, 0, "
        "0], [0, 0, 1, 1], [-1, 1, 0, 0], [0, 0, 1, -1]]))",
        "an array for a row",
    ),
    wrong(
        "2.13",
        "a_unobservable_states",
        "[[0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0], [1, 0, 0, 0, 0, 1]]",
        "a sign in the last one",
    ),
    wrong(
        "2.13",
        "c_hill",
        "sp.Matrix(6, 6, lambda i, j: int((i, j) in [(0, 0), (2, 2), (3, 3), (5, 0), (5, 5)])"
        " - int((i, j) == (3, 2)))",
        "singular, though S A is A' S",
    ),
    wrong(
        "2.13",
        "e_eigenvalues",
        "[[0, 2, 2], [sp.I, 2, 2], [-sp.I, 2, 2]]",
        "those of the motion in orbit",
    ),
    right(
        "2.13",
        "c_hill",
        "sp.Matrix(6, 6, lambda i, j: int(i == j or (i, j) == (5, 0)) - int((i, j) == (3, 2)))",
        "the displacements are x1, x2, x3",
    ),
    right(
        "2.13",
        "a_unobservable_states",
        "[[0, 1, 0, 0, 0, 0], [0, 0, 0, 0, 1, 0], [1, 0, 0, 0, 0, -1]]",
        "with a shift along",
    ),
    wrong(
        "2.14",
        "b_part",
        "[[1, 0, 0, 0], [0, -1, 1, 0], [-2, 0, 0, -2], [0, -2, -4, 0]]",
        "Kalman's rows",
    ),
    wrong(
        "2.14",
        "c_parallel",
        "sp.Matrix.vstack(z1, z3, z1*satellite, z3*satellite)",
        "by turns, not by parts",
    ),
    wrong(
        "2.14",
        "d_matrix",
        "[[0, 0, 1, 0], [0, 0, 0, 1], [0, 0, 0, -2], [0, 2, 2, 0]]",
        "gravity gives 2, rotation 1",
    ),
    right(
        "2.14",
        "c_parallel",
        "sp.Matrix.vstack(z1, z1*satellite, z1*satellite**2, z3)",
        "h1 A^2 is a multiple of h3 A",
    ),
    right(
        "2.14",
        "d_change",
        "3*sp.Matrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, -1, 1, 0], [1, 0, 0, 1]])",
        "in other units",
    ),
    wrong(
        "2.15",
        "c_sequential",
        "sp.Matrix.vstack(z1, z1*system, z2, z2*system)",
        "the parallel decomposition",
    ),
    wrong(
        "2.15",
        "d_parallel",
        "sp.Matrix.vstack(z1, z1*system + z2*system, z2, z2*system)",
        "a row of the same power of A is added",
    ),
    wrong(
        "2.15",
        "d_parallel",
        "sp.Matrix.vstack(z1 + z2, z1*system, z2, z2*system)",
        "z1 would hold part 2",
    ),
    right(
        "2.15",
        "d_parallel",
        "sp.Matrix.vstack(z1, z1*system + 3*z2, z2, z2*system - z1)",
        "rows of lower powers of A are added",
    ),
    wrong(
        "2.16",
        "c_unobservable_states",
        "{-1: [[-1, 1, 1]], -2: [[-2, 1, 2]], 0: [[0, 1, 0]]}",
        "for alpha = 0 it is observable",
    ),
    wrong("2.16", "d_region", "sp.Ne(sp.sin(sp.pi*omega), 0)", "omega = 2 is no resonance"),
    wrong("2.16", "d_state", "sp.Ne(omega, 1)", "omega = -1 is the same resonance"),
    wrong("2.16", "a_amplitude", "z - z1", "the sign of the derivative"),
    wrong(
        "2.16",
        "d_unobservable_states",
        "{0: [[0, 0, 1]], 1: [[0, 1, -1]], -1: [[0, 1, -1]]}",
        "the sine is odd in omega",
    ),
    right(
        "2.16",
        "d_amplitude",
        "sp.And(sp.Ne(omega, 0), sp.Ne(1/omega**2, 1))",
        "by the squared period",
    ),
    right("2.16", "b_amplitude", "(z + z2)/(2*sp.exp(t))", "a quotient"),
    right(
        "2.16",
        "d_augmented",
        "[sp.Matrix([[0, 1, 0, 0], [-1, 0, 0, 0], [0, 0, 0, 1], [0, 0, -omega**2, 0]]), "
        "sp.Matrix([[1, 0, 1, 0]])]",
        "the error and its rate",
    ),
    wrong("2.17", "rows", "sp.Matrix.vstack(H, H*A)", "the direction turns too"),
    wrong(
        "2.17",
        "output",
        "x10*sp.sin(sp.Abs(omega - 1)*t) + x20*sp.cos((omega - 1)*t)",
        "the sine is odd",
    ),
    wrong("2.17", "gramian", "[[sp.pi, 0], [0, sp.pi]]", "for whole and half omega alone"),
    wrong("2.17", "region", "sp.Ne(omega**2, 1)", "the other sense of turning is no exception"),
    right(
        "2.17",
        "gramian",
        "(lambda s, c: sp.ImmutableMatrix([[sp.pi - s, c], [c, sp.Piecewise((sp.pi + s, "
        "sp.Ne(omega, 1)), (2*sp.pi, True))]]))(sp.sin(4*sp.pi*omega)/(4*omega - 4), "
        "sp.sin(2*sp.pi*omega)**2/(2*omega - 2))",
        "a limit in one entry alone",
    ),
    wrong(
        "2.17",
        "gramian",
        "(lambda s, c: [[sp.pi - s, c], [c, sp.pi + s]])(*(sp.Piecewise((e, sp.Ne(omega, 1)), (1, "
        "True)) for e in (sp.sin(4*sp.pi*omega)/(4*omega - 4), sp.sin(2*sp.pi*omega)**2/(2*omega - "
        "2))))",
        "for omega = 1 the limits are pi and 0",
    ),
    right(
        "2.17", "output", "sp.im((x10 + sp.I*x20)*sp.exp(sp.I*(omega - 1)*t))", "a complex number"
    ),
    right(
        "2.17",
        "gramian",
        "(lambda c, s: [[sp.pi*(1 - s), c], [c, sp.pi*(1 + s)]])(sp.Integral(sp.sin(2*(omega - 1)"
        "*t)/2, (t, 0, 2*sp.pi)), sp.sinc(4*sp.pi*(omega - 1)))",
        "an integral and sinc",
    ),
    wrong("2.18", "b_region", "sp.And(beta > -1, beta < 1)", "large beta is controllable too"),
    wrong(
        "2.18", "b_uncontrollable_rows", "{1: [[1, 1]], -1: [[1, -1]]}", "they have changed places"
    ),
    right(
        "2.18", "b_uncontrollable_rows", "{s: [[s, -1]] for s in (1, -1)}", "by the sign of beta"
    ),
    wrong("2.19", "matrix", "[[0, 1, 0], [0, 0, 1], [2, 2, 0]]", "transposed"),
    wrong(
        "2.19",
        "canonical_basis",
        "2*sp.Matrix([[-1, 0, 1], [1, 1, 0], [1, 0, 0]])",
        "the last column is b itself",
    ),
    wrong(
        "2.20",
        "uncontrollable_rows",
        "{-6: [[1, -1]], sp.Rational(2, 3): [[3, 1]]}",
        "a root is zero for alpha = 2/3, nothing is lost",
    ),
    wrong("2.20", "basis", "[[alpha + 2, 1], [-4, 1.1]]", "the last column is b itself"),
    wrong(
        "2.20",
        "equation",
        "sp.Eq(y.diff(t, 2) + y.diff(t) + (3*alpha - 2.02)*y, u)",
        "one per cent off",
    ),
    right("2.20", "coordinate", "sp.Matrix([[1, -1]])/(alpha + 6)", "one fraction"),
    wrong("2.21", "equation", "sp.Eq(y.diff(t, 2) + 4.04*y.diff(t) + 3*y, u)", "one per cent off"),
    wrong(
        "2.21",
        "equation",
        "sp.Eq(0.33*y.diff(t, 2) + 1.33*y.diff(t) + y, 0.33*u)",
        "two digits of a third",
    ),
    wrong(
        "2.21",
        "equation",
        "sp.Eq(beta*(y.diff(t, 2) + 4*y.diff(t) + 3*y), beta*u)",
        "for beta = 0 it says nothing",
    ),
    wrong("2.21", "coordinate", "[1, -beta]", "the control enters with another coefficient"),
    wrong(
        "2.21",
        "uncontrollable_rows",
        "{1: [[2, -1]], sp.Rational(1, 2): [[1, -1]]}",
        "they have changed places",
    ),
    right("2.21", "possible", "sp.Ne(sp.Abs(beta - 0.75), 0.25)", "a quarter from the middle"),
    right(
        "2.21",
        "equation",
        "sp.Eq(0.333*y.diff(t, 2) + 1.33*y.diff(t) + y, 0.333*u)",
        "a third of it, three digits",
    ),
    right(
        "2.21",
        "equation",
        "sp.Eq((beta - 1)*(y.diff(t, 2) + 4*y.diff(t) + 3*y), (beta - 1)*u)",
        "beta = 1 is an exception anyway",
    ),
    wrong(
        "2.22",
        "second_equation",
        "sp.Eq(x2.diff(t, 2) - 2*x2.diff(t) + 4*x2, u1.diff(t) - 1.01*u1)",
        "one per cent off",
    ),
    wrong(
        "2.22",
        "second_equation",
        "sp.Eq(x2.diff(t, 3) - 2*x2.diff(t, 2) + 4*x2.diff(t), u1.diff(t, 2) - u1.diff(t))",
        "differentiated once more",
    ),
    right(
        "2.22",
        "second_equation",
        "x2.diff(t, 2) - 2*x2.diff(t) + 4*x2 - u1.diff(t) + u1",
        "what is to be zero",
    ),
    wrong("2.23", "b_region", "sp.Ne(p*(p - 2)*(p - 3), 0)", "p = 3 is controllable"),
    wrong(
        "2.23",
        "c_uncontrolled",
        "{2: [[2, 0, -1]], 3: [[2, -1, -1]], 1: [[1, 1, 1]]}",
        "nothing is lost at r = 1",
    ),
    right("2.23", "b_region", "sp.Abs(p - 2) > 0", "a distance"),
    right("2.23", "d_lower_pipe", "sp.Ne(r**2, 4)", "r is positive"),
    wrong(
        "2.24",
        "a_uncontrolled",
        "{0: [[1, 0, 0]], 2: [[-1, 1, 1]]}",
        "at 0 two combinations are lost",
    ),
    wrong("2.24", "c_region", "sp.And(sp.Ne(alpha, -1), sp.Ne(alpha, 2.02))", "one per cent off"),
    wrong("2.24", "d_uncontrolled", "[[alpha, -alpha, 0]]", "zero for alpha = 0"),
    right(
        "2.24",
        "d_uncontrolled",
        "[[1 + alpha**2, -1 - alpha**2, 0]]",
        "the factor vanishes nowhere",
    ),
    right("2.24", "d_region", "alpha**2 < 0", "it holds nowhere"),
    wrong("2.25", "a_region", "sp.Ne(alpha**2, 1)", "alpha = -1 is controllable"),
    right("2.25", "b_uncontrolled", "{0: [1, 0, -1]}", "the vector alone"),
    wrong(
        "2.26", "c_region", "sp.And(sp.Ne(k, 12.6), sp.Ne(k, 0.393))", "the smaller root is 0.3967"
    ),
    wrong("2.26", "c_region", "sp.Ne(k**2 - 13.1*k + 5, 0)", "13 to three digits is 13.0"),
    wrong(
        "2.26",
        "d_roots",
        "[sp.I, -sp.I, sp.sqrt(sp.Abs(3 - beta)), -sp.sqrt(sp.Abs(3 - beta))]",
        "imaginary for beta > 3",
    ),
    right(
        "2.26", "c_region", "sp.And(sp.Ne(k, 12.6), sp.Ne(k, 0.397))", "the roots to three digits"
    ),
    right(
        "2.26",
        "c_region",
        "sp.And(*[sp.Ne(k, float(root)) for root in np.roots([1, -13, 5])])",
        "as NumPy does",
    ),
    right("2.26", "d_region", "sp.Ne(sp.sqrt(3 - beta), 0)", "the root that comes to zero"),
    wrong("2.27", "controllable", "sp.Ne(beta**3, beta)", "beta = -1 is controllable"),
    wrong(
        "2.27",
        "equation",
        "sp.Eq(beta*(z.diff(t, 2) + 3*z.diff(t) + 2*z), beta*((1 + alpha*beta)*u.diff(t)"
        " + (2 - beta + alpha*beta)*u))",
        "for beta = 0 this says nothing",
    ),
    right(
        "2.27",
        "equation",
        "sp.Eq((1 + beta**2)*(z.diff(t, 2) + 3*z.diff(t) + 2*z), (1 + beta**2)*((1 + alpha*beta)"
        "*u.diff(t) + (2 - beta + alpha*beta)*u))",
        "the factor vanishes nowhere",
    ),
    right("2.27", "controllable", "sp.Xor(sp.Ne(beta, 0), sp.Eq(beta, 1))", "an exclusive or"),
    wrong("2.28", "split_system", "[[[2.02, 0], [0, -1]], [1, 0]]", "one per cent off"),
    wrong("2.28", "split", "[[1, 1], [-1, 1]]", "as rows"),
    right(
        "2.28",
        "split_system",
        "[[[2, 1], [0, -1]], [[0.001], [0]]]",
        "in small units, eta acts on xi",
    ),
    wrong("2.29", "region", "sp.Ne(a, 1)", "a = -2 is no better"),
    wrong(
        "2.29", "uncontrolled_where", "{1: [[2, -1]], -2: [[1, -1]]}", "a sign at the second value"
    ),
    wrong(
        "2.30",
        "a_split",
        "[[0, 1, 1], [1, 1, 0], [0, -1, -1]]",
        "the last column follows from the others",
    ),
    wrong("2.30", "e_uncontrolled", "[[0, 1, 0], [1, 0, 0]]", "x1 is reached through x3"),
    wrong("2.30", "l_split", "[[1, -1, 0], [1, 0, 0], [0, 1.01, 1]]", "one per cent off"),
    right(
        "2.30", "g_split", "[[0, 1, 1], [0, -1, 0], [1, 1, 0]]", "other columns of the same space"
    ),
    wrong("2.31", "b_uncontrolled", "[[0, omega*(omega - 1), omega - 1, 0]]", "zero for omega = 1"),
    wrong(
        "2.31",
        "b_split",
        "[[omega - 2, 0, 0, 0], [0, 1, 0, 0], [0, -omega, 0, 1], [-omega*(omega - 2), 0, 1, 0]]",
        "singular for omega = 2",
    ),
    right(
        "2.31",
        "b_split",
        "[[omega, 0, 0, 0], [0, 1, 0, 0], [0, -omega, 0, 1], [-omega**2, 0, 1, 0]]",
        "the first column times the positive omega",
    ),
    wrong("2.32", "e_uncontrollable_eigenvalues", "[1.6, -0.6]", "two digits of the golden ratio"),
    right("2.32", "e_uncontrollable_eigenvalues", "[1.62, -0.618]", "three digits each"),
    right(
        "2.32",
        "e_uncontrollable_eigenvalues",
        "[2*sp.cos(sp.pi/5), -2*sp.cos(2*sp.pi/5)]",
        "in the regular pentagon",
    ),
    wrong("2.33", "missed_by_u2", "[[0, 0, 0, 1], [0, 0, 0, 2]]", "twice the same row"),
    wrong(
        "2.33",
        "parallel",
        "sp.Matrix.hstack(b1, A*b1 + A*b2/10, b2, A*b2)",
        "a column of the same power is added",
    ),
    right(
        "2.33",
        "parallel_system",
        "[[[0, -3, 0, 1.0], [1, 3.5, 0, -0.5], [0, 0.5, 0, -1.5], [0, -0.5, 1, 2.5]],"
        " [[1, 0], [0, 0], [0, 1], [0, 0]]]",
        "nested lists of decimals",
    ),
    wrong(
        "2.33",
        "parallel_system",
        "[[[0, -3, 0, 1.0], [1, 3.5, 0, -0.5], [0, 0.5, 0, -1.5], [0, -0.5, 1, 2.6]],"
        " [[1, 0], [0, 0], [0, 1], [0, 0]]]",
        "another trace",
    ),
    wrong(
        "2.33",
        "parallel_system",
        "[[[0, 0, -3, 1], [0, 0, half, -3*half], [1, 0, 7*half, -half], [0, 1, -half, 5*half]],"
        " [[1, 0], [0, 1], [0, 0], [0, 0]]]".replace("half", "sp.Rational(1, 2)"),
        "a similar system whose coordinates stand in the order of the powers",
    ),
    right(
        "2.34",
        "parallel_system",
        "[[[0, 0, -1, 4], [1, 1, 1, 0], [0, 1, 1, -2], [0, 0, 0, 1]],"
        " [[1, 0], [0, 0], [0, 1], [0, 0]]]",
        "the last column is (0, 1, -1, 0)",
    ),
    wrong(
        "2.34",
        "parallel_system",
        "[[[0, 0, -1, 1], [1, 1, 1, 1], [0, 1, 1, -1], [0, 0, 0, 1]],"
        " [[1, 0], [0, 0], [0, 1], [0, 1]]]",
        "a control enters what is left over",
    ),
    wrong("2.34", "missed_by_u2", "[[0, 1, -1, 0]]", "one row of two"),
    wrong(
        "2.34",
        "parallel",
        "sp.Matrix.hstack(b1, A*b1, b2 + b1/100, sp.Matrix([0, 1, 0, 0]))",
        "one per cent of part 1 in part 2",
    ),
    wrong(
        "2.34",
        "reversed_order",
        "sp.Matrix.hstack(b2, b1, A*b2, sp.Matrix([0, 0, 1, 0]))",
        "u2 reaches two first",
    ),
    right(
        "2.34",
        "sequential",
        "sp.Matrix([[0, 1, 0, 0], [1, 0, 0, 0], [1, 0, 0, 1], [0, 0, 1, 0]])",
        "unit vectors of the parts",
    ),
    right(
        "2.34",
        "parallel",
        "sp.Matrix.hstack(b1, A*b1 - 2*b2, b2, sp.Matrix([5, -1, 1, 2]))",
        "a column of a lower power is added",
    ),
    wrong("2.35", "region", "sp.Ne(l1**2 - 3*l1*l2 + 2*l2**2, 0)", "l1 = 2 l2 is controllable"),
    wrong(
        "2.35",
        "equations",
        "[sp.diag(l1, l2), -g*sp.eye(2), sp.Matrix([-1, -l2])]",
        "the second link's right side",
    ),
    right("2.35", "region", "sp.Ne(sp.log(l1/l2), 0)", "both are positive"),
    right(
        "2.35",
        "equal_uncontrollable_eigenvalues",
        "[sp.sqrt(g*l)/l, -sp.sqrt(g*l)/l]",
        "the root in the numerator",
    ),
    wrong(
        "2.36",
        "equations",
        "[sp.Matrix([[(m1 + m2)*l1, l2], [l1, l2]]), -g*sp.diag(m1 + m2, 1), "
        "-sp.Matrix([m1 + m2, 1])]",
        "the second mass is lost",
    ),
    wrong(
        "2.36",
        "equations",
        "[(m1 - m2)*M, (m1 - m2)*K, (m1 - m2)*L]",
        "for equal masses they say nothing",
    ),
    wrong(
        "2.36",
        "roots",
        "[s*sp.sqrt(g/l) for s in (1, -1) for l in (l1, l2)]",
        "those of separate pendulums",
    ),
    wrong(
        "2.36", "side_by_side", "sp.And(sp.Ne(l1, l2), l1 + l2 < 100)", "nothing bounds the lengths"
    ),
    right(
        "2.36",
        "equations",
        "[sp.Matrix([[(m1 + m2)*l1, m2*l2], [l1, l2]]), -g*sp.diag(m1 + m2, 1), "
        "-sp.Matrix([m1 + m2, 1])]",
        "divided by lengths and a mass",
    ),
    wrong("2.37", "c_region", "sp.Ne(b1*(b1 - 2*b2), 0)", "b1 = 2 b2 is controllable"),
    right("2.37", "c_region", "sp.sign(b1)**2 > 0", "by the sign"),
    wrong("2.1", "a_canonical", "[[0, 2], [1, 0]]", "transposed"),
    right("2.1", "a_canonical", "np.array([[0, 1], [2, 0]])", "an array"),
    wrong("2.1", "a_canonical", "[[0, 1], [-2, 0]]", "a sign"),
    wrong("2.1", "a_canonical", "[[2, 0], [0, 1]]", "swapped"),
    right("2.5", "c_unobservable_states", "[[0, 1, -1]]", "opposite"),
    wrong("2.5", "c_unobservable_states", "[[0, 1, 1]]", "a sign"),
    right("2.5", "c_unobservable_states", "sp.Matrix([0, -2, 2])", "a column"),
    wrong("2.5", "c_unobservable_states", "[]", "not observable"),
    wrong("2.5", "c_unobservable_states", "[[0, -1, 1], [0, 1, -1]]", "dependent"),
    wrong("2.7", "c_unobservable_states", "[[1, 1, 1, 1]]", "a sign of the speed"),
    right("2.7", "c_unobservable_states", "[[-1, -1, 1, 1]]", "opposite"),
    right("2.14", "a_unobservable_states_z3", "[[-1, 0, 0, 1]]", "opposite"),
    wrong("2.14", "a_unobservable_states_z3", "[[1, 0, 0, 1]]", "a sign"),
    wrong("2.14", "a_unobservable_states_z3", "[[1, 0, 0, 0]]", "kappa alone"),
    wrong("2.18", "a_kalman", "[[1, 0], [0, 1]]", "columns exchanged"),
    right("2.18", "a_kalman", "np.array([[0, 1], [1, 0]])", "an array"),
    wrong("2.20", "canonical", "[[0, 1], [3*alpha-2, -1]]", "a sign"),
    wrong("2.20", "canonical", "[[0, 2-3*alpha], [1, -1]]", "transposed"),
    wrong("2.20", "canonical", "[[0, 1], [-1, 2-3*alpha]]", "order of the coefficients"),
    right("2.24", "a_region", "sp.Ne(alpha**2, 2*alpha)", "an equation of second degree"),
    wrong("2.24", "a_region", "sp.Ne(alpha, 2)", "one of two"),
    wrong("2.24", "a_region", "sp.And(sp.Ne(alpha, 0), sp.Ne(alpha, -2))", "a sign"),
    wrong("2.24", "a_region", "sp.Or(sp.Ne(alpha, 0), sp.Ne(alpha, 2))", "Or is everything"),
    right("2.26", "a_roots", "[1.233*sp.I, -1.233*sp.I, 0.9595, -0.9595]", "decimals"),
    wrong("2.26", "a_roots", "[1.23*sp.I, -1.23*sp.I, 0.96]", "one is missing"),
    right("2.28", "uncontrollable_eigenvalues", "{-1}", "as a set"),
    wrong("2.28", "uncontrollable_eigenvalues", "[2]", "the controlled one"),
    wrong("2.28", "uncontrollable_eigenvalues", "[-1, 2]", "both of them"),
    right("2.28", "uncontrollable_eigenvalues", "-1", "a number"),
    right("2.28", "uncontrollable_eigenvalues", "[-1.0]", "as a float"),
    right("2.34", "uncontrolled", "[[0, -2, 2, 0]]", "a multiple"),
    wrong("2.34", "uncontrolled", "[[0, 1, 1, 0]]", "a sign"),
    wrong("2.34", "uncontrolled", "[]", "one is left"),
    wrong(
        "2.20",
        "equation",
        "(alpha+5)*(y.diff(t, 2)+y.diff(t)+(3*alpha-2)*y-u)",
        "nothing is said for alpha = -5",
    ),
    wrong(
        "2.6",
        "d_unobservable_states",
        "[[1, 0, 0, 0], [0, -2*r0/(r0-1), 3*Omega/(r0-1), 0]]",
        "without a value for r0 = 1",
    ),
    wrong("2.8", "split", "[[(l**2-1)/(l-1)/(l+1), 1], [1, -1]]", "without a value for l = 1"),
    wrong(
        "2.35",
        "equations",
        "[sp.diag(l1*(l1-1), l2), sp.diag(-g*(l1-1), -g), [-(l1-1), -1]]",
        "nothing for l1 = 1",
    ),
    right(
        "2.7",
        "a_roots",
        "sp.Poly(3*sp.Symbol('s')**4 + 2*sp.Symbol('s')**2 - 1).all_roots()",
        "as a polynomial gives them",
    ),
    right(
        "2.26",
        "a_roots",
        "sp.Poly((2*sp.Symbol('s')**2 + 3)*(3*sp.Symbol('s')**2 - 2) "
        "- (sp.Symbol('s')**2 + 1)**2).all_roots()",
        "roots that SymPy only counts",
    ),
    wrong(
        "2.6",
        "d_unobservable_states",
        "[[1, 0, 0, 0], [0, -2*r0*sp.sin(r0), 3*Omega*sp.sin(r0), 0]]",
        "zero where r0 is pi",
    ),
    right("2.8", "split", "[[1, 1], [1 + sp.Abs(l), -1]]", "the determinant is nowhere zero"),
    right(
        "2.10", "split_system", "[[[0, 1, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 0]]]", "the rate first"
    ),
    right(
        "2.17",
        "output",
        "sp.re((x20 - sp.I*x10)*sp.exp(sp.I*(omega - 1)*t))",
        "a complex exponential",
    ),
    wrong(
        "2.17",
        "output",
        "sp.Piecewise((x10*sp.sin(t*(omega - 1)) + x20*sp.cos(t*(omega - 1)), "
        "sp.Abs(omega) < 300), (0, True))",
        "nothing when it turns fast",
    ),
    wrong("2.17", "gramian", "sp.pi*sp.eye(2)", "for whole numbers alone"),
    right(
        "2.26",
        "d_roots",
        "[sp.I, -sp.I, sp.Piecewise((sp.sqrt(3 - beta), beta <= 3), (sp.I*sp.sqrt(beta - 3), "
        "True)), -sp.sqrt(3 - beta)]",
        "in two cases",
    ),
    right("2.26", "c_region", "(k < 0.397) | ((k > 0.397) & (k < 12.6)) | (k > 12.6)", "intervals"),
    right(
        "2.26", "c_region", "sp.S.Reals - sp.FiniteSet(0.397, 12.6)", "a set without two numbers"
    ),
    wrong(
        "2.26", "c_region", "(k < 0.397) | ((k >= 0.397) & (k < 12.6)) | (k > 12.6)", "0.397 too"
    ),
    wrong("2.26", "c_region", "sp.S.Reals - sp.FiniteSet(0.4, 12.6)", "0.397 to one digit"),
]
