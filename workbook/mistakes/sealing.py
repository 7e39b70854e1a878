"""Seal sentences so that only the wrong answer they belong to opens them.

The HMAC of an answer's signature, keyed by its problem and name, gives a secret; the secret gives a
fingerprint, by which the sentence is found, and a key, by which it is encrypted. This hides answers
and sentences from reading and from any search of the files. It does not hide them from trials: all
of a few possible answers can be tried. So they can in the check cell, which judges as many answers
as one likes; so there is nothing more to protect, and no need of a slow hash or of more than the
standard library.
"""

import base64
import hashlib
import hmac


def seal(sentence, salt, signature):
    """Seal a sentence with the signature of its answer.

    Parameters
    ----------
    sentence : str
        The sentence.
    salt : str
        Problem and name of the answer.
    signature : bytes
        Signature of the wrong answer (`workbook.mistakes.signature`).

    Returns
    -------
    fingerprint, sealed : str
        The fingerprint in hexadecimal digits and the encrypted sentence in base64.
    """
    fingerprint, key = _secrets(salt, signature)
    return fingerprint, base64.b64encode(_xor(sentence.encode(), key)).decode()


def find(sealed, salt, signatures):
    """Return the sentence that one of several signatures opens, or "".

    Parameters
    ----------
    sealed : dict of str
        Sealed sentences by fingerprint.
    salt : str
        Problem and name of the answer.
    signatures : iterable of bytes
        Signatures of the answer, its own first.

    Returns
    -------
    str
        The sentence of the first signature with one.
    """
    for signature in signatures:
        fingerprint, key = _secrets(salt, signature)
        if fingerprint in sealed:
            return _xor(base64.b64decode(sealed[fingerprint]), key).decode()
    return ""


def _secrets(salt, signature):
    """Return (fingerprint, key)."""
    secret = hmac.digest(salt.encode(), signature, "sha256")
    return hmac.digest(secret, b"fingerprint", "sha256").hex()[:24], hmac.digest(
        secret, b"key", "sha256"
    )


def _xor(text, key):
    """Encrypt or decrypt bytes with the stream of a key."""
    return bytes(a ^ b for a, b in zip(text, hashlib.shake_256(key).digest(len(text))))
