# %% wrong
# Does the noise enter both coordinates within one step? (hint 1)
first = sp.diag(alpha**2 * Q, Q)
first = sp.diag(alpha * p22, Q)  # How does a factor enter a variance? (hint 1)
# Does the new $x_2$ depend on the old state? (hint 2)
first = sp.Matrix([[alpha**2 * p22, alpha * p12], [alpha * p12, Q]])
later = sp.diag(alpha**2 * p22, Q)  # What is $p_{22}$ one step later? (hint 1)
later = sp.diag(alpha ** (2 * i) * p22, Q)  # Is there a new factor $\alpha$ in every step? (hint 1)
# Is it the same noise in both coordinates at one instant? (hint 1)
later = sp.Matrix([[alpha**2 * Q, alpha * Q], [alpha * Q, Q]])
state = [alpha * q2, q2]  # Do both coordinates contain the same noise? (hint 1)
state = [alpha * x2, q2]  # Is this the first coordinate after one step? (hint 1)
state = [alpha * q1, q0 + q1 + q2]  # Does the second coordinate keep its old value? (hint 1)
settles = abs(alpha) < 1  # Is $\alpha$ an eigenvalue? (hint 1)
settles = False  # Take two steps from two different initial states. (hint 1)

# %% right
later = sp.diag(alpha**2, 1) * Q  # a factor in front
settles = alpha**2 >= 0  # for all
