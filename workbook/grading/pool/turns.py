"""Turns: in which order the notebooks of a class are graded, and when a student's budget is used up.

Whose turn it is next has fewest notebooks running and has used least time so far. So a student whose
hundred notebooks never end keeps nobody waiting: after the first, all others come first.
"""

from collections import Counter, deque


class Turns:
    """An iterator of tasks that are handed out in turn.

    Parameters
    ----------
    tasks : dict
        Lists of tasks by owner.
    used : dict
        Seconds of computing that owners have used up before.
    budgets : dict
        Seconds that each owner may use up; no task is handed out beyond them.
    """

    def __init__(self, tasks, used, budgets):
        self._waiting = {owner: deque(of_owner) for owner, of_owner in tasks.items()}
        self._used, self._budgets, self._running = Counter(used), budgets, Counter()
        self.left_over = []

    def __iter__(self):
        return self

    def __next__(self):
        while self._waiting:
            owner = min(self._waiting, key=lambda owner: (self._running[owner], self._used[owner]))
            tasks = self._waiting[owner]
            if self._used[owner] >= self._budgets[owner]:
                self.left_over += self._waiting.pop(owner)
                continue
            if len(tasks) == 1:
                del self._waiting[owner]
            self._running[owner] += 1
            return tasks.popleft()
        raise StopIteration

    def done(self, owner, seconds):
        """Note that a task of an owner has ended, and what it used."""
        self._running[owner] -= 1
        self._used[owner] += seconds
