# %% wrong
# Which sign does the vertical component of the thrust have in the equations?
pontryagin = psi1 * v_x + psi2 * v_y + a * psi3 * sp.cos(theta) - a * psi4 * sp.sin(theta)
# Is the cost an integral here, or a terminal cost? (hint 1)
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta)) - 1
adjoint = [0, 0, psi1, psi2]  # Which sign precedes the derivative of $H$?
adjoint = [0, 0, 0, 0]  # Does $H$ not change with the velocity? (hint 1)
# Is a large coordinate with a positive weight good or bad for this cost? (hint 1)
transversality = [psi1 + k1, psi2 + k2, psi3 + k3, psi4 + k4]
transversality = [psi1, psi2, psi3, psi4]  # Does the cost not depend on the final state? (hint 1)
# What is integrated to get the time? (hint 1)
time_pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta))
# Is the time to be maximised or minimised? (hint 1)
time_pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta)) + 1
time_transversality = [psi1, psi2]  # Is the position free at the end, or the velocity? (hint 1)
time_transversality = [psi1, psi2, psi3, psi4]  # Can all costates vanish together? (hint 1)
# Where does the thrust point if both costates are negative? (hint 2)
direction = sp.atan(psi4 / psi3)
direction = sp.atan2(psi3, psi4)  # Which costate belongs to the sine? (hint 1)
direction = sp.atan2(-psi4, -psi3)  # Does this direction maximise or minimise $H$? (hint 2)
# Does the derivative of your third costate have the sign that the adjoint equation gives? (hint 2)
costate = [k1, k2, k3 - k1 * (T - t), k4 - k2 * (T - t)]
# At which end are the values of the costates known? (hint 2)
costate = [k1, k2, k3 - k1 * t, k4 - k2 * t]
# Which sign does the cost have in transversality? (hint 1)
costate = [-k1, -k2, -k3 - k1 * (T - t), -k4 - k2 * (T - t)]
# Is the cosine of your angle ever negative? (hint 1)
angle = sp.atan((k4 + k2 * (T - t)) / (k3 + k1 * (T - t)))
# What are the values of the costates at the end? (hint 1)
angle = sp.atan2(k4 - k2 * t, k3 - k1 * t)
angle = sp.atan2(k4, k3)  # Does the final position have no value? (hint 1)
# Which component of the thrust is in the numerator of a tangent? (hint 1)
tangent = (k3 + k1 * (T - t)) / (k4 + k2 * (T - t))
tangent = (k4 - k2 * t) / (k3 - k1 * t)  # What are the values of the costates at the end?
tangent = k4 / k3 + k2 * (T - t)  # Does the other costate change too?

# %% right
# sum and difference
transversality = [psi1 - k1, psi2 - k2, psi3 + psi4 - k3 - k4, psi3 - psi4 - k3 + k4]
direction = sp.sign(psi4) * sp.acos(psi3 / sp.sqrt(psi3**2 + psi4**2))  # by the cosine
direction = 2 * sp.atan(psi4 / (psi3 + sp.sqrt(psi3**2 + psi4**2)))  # by half the angle
angle = sp.arg(k3 + k1 * (T - t) + sp.I * (k4 + k2 * (T - t))) + 2 * sp.pi  # another turn
tangent = sp.tan(sp.atan2(k4 + k2 * (T - t), k3 + k1 * (T - t)))  # by the angle
