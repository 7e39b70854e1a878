# %% wrong
# Where is the cost? (hint 1)
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta))
# Which sign does the cost have in the function that is maximised? (hint 1)
pontryagin = psi1 * v_x + psi2 * v_y + a * (psi3 * sp.cos(theta) + psi4 * sp.sin(theta)) + 1
adjoint = [0, 0, psi1, psi2]  # Which sign precedes the derivative of $H$? (hint 1)
# Which states does $H$ contain, the positions or the velocities? (hint 1)
adjoint = [-psi3, -psi4, 0, 0]
transversality = [psi1, psi2]  # Is the position free at the end, or the velocity? (hint 1)
transversality = [psi1, psi2, psi3, psi4]  # Is nothing given at the end? (hint 1)
direction = sp.atan(psi4 / psi3)  # Try a thrust that has to point backwards. (hint 2)
direction = sp.atan2(psi3, psi4)  # Which of the costates belongs to the cosine? (hint 1)
direction = sp.atan2(-psi4, -psi3)  # Does this maximise or minimise $H$? (hint 1)
# How far does a constant thrust move the point? (hint 2)
equation = sp.Eq(a**2 * T**4, (x0 + v_x0 * T) ** 2 + (y0 + v_y0 * T) ** 2)
# Was the initial velocity forgotten? (hint 2)
equation = sp.Eq(a**2 * T**4 / 4, x0**2 + y0**2)
# Where would the point be without thrust? (hint 2)
equation = sp.Eq(a**2 * T**4 / 4, (x0 - v_x0 * T) ** 2 + (y0 - v_y0 * T) ** 2)
# How far does a constant thrust move the point? (hint 1)
rest_time = sp.sqrt(sp.sqrt(x0**2 + y0**2) / a)
# Does the interceptor have to stop at the target? (hint 1)
rest_time = 2 * sp.sqrt(sp.sqrt(x0**2 + y0**2) / a)
# Is the sign of the costate that of the position, or of the direction of the thrust? (hint 1)
d = sp.sqrt(x0**2 + y0**2)
k = 1 / (a * d * sp.sqrt(2 * d / a))
rest_costate = [
    x0 * k,
    y0 * k,
    x0 * k * (sp.sqrt(2 * d / a) - t),
    y0 * k * (sp.sqrt(2 * d / a) - t),
]
# Does $H$ vanish at the end with these? (hint 2)
e = sp.sqrt(x0**2 + y0**2)
rest_costate = [
    -x0 / e,
    -y0 / e,
    -x0 / e * (sp.sqrt(2 * e / a) - t),
    -y0 / e * (sp.sqrt(2 * e / a) - t),
]
angle = -2.034444  # Does the interceptor stay at its initial position without thrust? (hint 1)
angle = 0.464979  # Is this towards the target or away from it? (hint 1)
head_on = 3 - sp.sqrt(5)  # Does the interceptor pass the target earlier? (hint 1)
head_on = 3 + sp.sqrt(5)  # Does the interceptor have to turn back? (hint 1)
past = 0.7  # Which roots are left if the initial state is not on the line? (hint 1)
past = 2 * sp.sqrt(2) + 3  # Does the interceptor have to stop where it meets the target? (hint 1)

# %% right
transversality = [psi3 + psi4, psi3 - psi4]  # combined
# by the cosine, with the sign of the sine
acute = sp.acos(psi3 / sp.sqrt(psi3**2 + psi4**2))
direction = sp.Piecewise((acute, psi4 >= 0), (-acute, True))
equation = sp.Eq(sp.sqrt((x0 + v_x0 * T) ** 2 + (y0 + v_y0 * T) ** 2), a * T**2 / 2)  # with roots
angle = 3.606571  # a turn more
