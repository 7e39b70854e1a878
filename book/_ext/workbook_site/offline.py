"""Nothing is loaded from another host."""


def _without_thebe(app):
    """Undo sphinx-thebe: Jupyter Book always loads it, and it links a CDN in every page."""
    for listeners in list(app.events.listeners.values()):
        for listener in list(listeners):
            if listener.handler.__module__ == "sphinx_thebe":
                app.disconnect(listener.id)
    app.registry.css_files = [
        (name, options) for name, options in app.registry.css_files if name != "sphinx-thebe.css"
    ]


def setup(app):
    app.setup_extension("sphinx_thebe")
    _without_thebe(app)
