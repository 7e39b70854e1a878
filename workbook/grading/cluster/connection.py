"""Connection to the scheduler of a Dask cluster, with TLS, and errors that say what to do."""

import logging
import os
import queue
import socket
import ssl
import threading
import warnings
from contextlib import contextmanager, suppress
from urllib.parse import urlsplit

from workbook.grading.course.assignment import InputError

#: Seconds to reach the scheduler.
CONNECT_SECONDS = 10


class ClusterError(InputError):
    """The cluster cannot be used, or not any more; the message is one line with the reason."""


@contextmanager
def connected(cluster):
    """Connect to a `Cluster`; gives a `distributed.Client`.

    Dask's own messages on its connections are silenced: they fill pages.
    """
    client_security, distributed = security(cluster), _dask()
    for name in ("distributed", "distributed.client", "tornado", "asyncio"):
        logging.getLogger(name).setLevel(logging.CRITICAL)
    try:
        with warnings.catch_warnings():
            # `dask_worker` compares the versions of the machines itself.
            warnings.simplefilter("ignore")
            # Dask's own timeout does not cover a server that accepts but never answers.
            client = _within(
                3 * CONNECT_SECONDS,
                lambda: distributed.Client(
                    cluster.address,
                    security=client_security,
                    timeout=CONNECT_SECONDS,
                    set_as_default=False,
                ),
            )
    except (OSError, RuntimeError, TypeError, ValueError) as error:
        cause = innermost_cause(error)
        # These are of Dask's last attempt, cut short: the one before it failed for a reason.
        if cause in ("CancelledError", "TimeoutError"):
            cause = _why_unreachable(cluster.address)
        hint = (
            "; is its certificate signed by the same CA, and does it use TLS?"
            if "ssl" in cause.lower()
            else ""
        )
        raise ClusterError(
            f"no scheduler can be reached at {cluster.address}: {cause}{hint}"
        ) from None
    try:
        yield client
    finally:
        with suppress(Exception):
            client.close(timeout=5)


def _dask():
    try:
        import distributed  # only clusters need it, and its import takes long
    except ImportError:
        raise ClusterError(
            "grading on a cluster needs Dask, which is not installed here: "
            "pip install 'trajlib[cluster]'"
        ) from None
    return distributed


def security(cluster):
    """Return what a connection to this address needs: None, or the certificates.

    Raises `ClusterError` for what can be seen without a connection: no Dask, no address, no
    certificates.
    """
    distributed = _dask()
    try:
        parts = urlsplit(cluster.address)
        valid = (
            parts.scheme in ("tls", "tcp")
            and parts.hostname
            and parts.port
            and not (parts.path or parts.query)
        )
    except ValueError:
        valid = False
    if not valid:
        raise ClusterError(
            f"{cluster.address} is not the address of a scheduler, which looks like tls://host:8786"
        )
    if parts.scheme == "tcp":
        return None
    options = {
        "tls_ca_file": ("--tls-ca-file", cluster.ca_file),
        "tls_client_cert": ("--tls-cert", cluster.cert),
        "tls_client_key": ("--tls-key", cluster.key),
    }
    files = {name: str(path) for name, (_, path) in options.items() if path is not None}
    client_security = distributed.Security(require_encryption=True, **files)
    for name, (option, _) in options.items():
        path = getattr(client_security, name)
        if path is None:
            raise ClusterError(
                f"{cluster.address} needs certificates; {option} names a file of them, as --help "
                "tells"
            )
        if not os.access(path, os.R_OK):
            raise ClusterError(f"{option} {path}: there is no such file that could be read")
    try:
        client_security.get_connection_args("client")
    except ssl.SSLError as error:
        raise ClusterError(f"these certificates cannot be used: {innermost_cause(error)}") from None
    return client_security


def innermost_cause(error):
    """Return the innermost reason of an error in one line, without Dask's words around it."""
    while error.__cause__ is not None:
        error = error.__cause__
    return " ".join(str(error).rpartition("Error: ")[2].split())[:200] or type(error).__name__


def _within(seconds, function):
    """Return `function()`, or raise `TimeoutError` and leave its thread behind."""
    results = queue.SimpleQueue()

    def work():
        try:
            results.put((function(), None))
        except BaseException as error:
            results.put((None, error))

    threading.Thread(target=work, daemon=True).start()
    try:
        value, error = results.get(timeout=seconds)
    except queue.Empty:
        raise TimeoutError from None
    if error is not None:
        raise error
    return value


def _why_unreachable(address):
    """Return why no connection to an address is possible, from a plain TCP connection."""
    parts = urlsplit(address)
    try:
        with socket.create_connection((parts.hostname, parts.port), timeout=CONNECT_SECONDS):
            return f"something listens there, but gives no answer within {CONNECT_SECONDS} s"
    except TimeoutError:
        return f"no answer within {CONNECT_SECONDS} s"
    except OSError as error:
        return error.strerror or str(error)
