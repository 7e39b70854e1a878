"""Pages of the site are executed where nothing forks."""

import shutil
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from test_elsewhere import ROOT, python, simulated

pytestmark = pytest.mark.slow
PAGE = """\
---
jupytext: {text_representation: {extension: .md, format_name: myst}}
kernelspec: {name: python3}
---
# Страница

```{code-cell} ipython3
import sympy as sp
print("✓", sp.factor(sp.Symbol("x") ** 2 - 1))
```
"""
RUN = """\
import sys
from pathlib import Path
sys.path.insert(0, {book!r})
if __name__ == "__main__":
    from execute import main
    sys.exit(main(Path({root!r})))
"""


@simulated  # the extra `book` is not there
def test_a_page_is_executed(tmp_path):
    root = tmp_path / "моя книга"
    root.mkdir()
    for name in ("_config.yml", "requirements.txt"):
        shutil.copy(ROOT / name, root)
    (root / "_toc.yml").write_text("format: jb-book\nroot: index\n", encoding="utf-8")
    (root / "index.md").write_text(PAGE, encoding="utf-8")
    script = tmp_path / "run.py"
    script.write_text(RUN.format(book=str(ROOT / "book"), root=str(root)), encoding="utf-8")
    python(str(script), cwd=tmp_path)
    [executed] = Path(root, "_build", ".jupyter_cache").rglob("*.ipynb")
    assert "(x - 1)*(x + 1)" in executed.read_text(encoding="utf-8")
