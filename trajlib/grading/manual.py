"""Points that a lecturer gives by hand: they beat the automatic ones, also after a regrade, until they are taken
back."""


def take_back(store, student, assignment, problem, answer):
    """Remove a lecturer's score, so that the automatic one counts again; returns False if there was none."""
    done = store._database.execute("DELETE FROM manual WHERE student = ? AND assignment = ? AND problem = ? AND "
                                   "answer = ?",
                                   (student, assignment, problem, answer))
    return done.rowcount > 0
