"""Sentences that only the one can open who has the wrong answer they are for.

A signature of the answer, salted by its problem and name, gives a secret; the secret gives a
fingerprint, by which the sentence is found, and a key, under which it is sealed. This hides answers
and sentences from reading and from any search of the files. It does not hide them from trying: of a
few possible answers all can be tried. But so can they in the check cell itself, which says wrong or
right of as many as one likes; there is nothing more to protect, and so no need of a slow hash or of
more than the standard library.
"""

import base64
import hashlib
import hmac


def seal(sentence, salt, signature):
    """(fingerprint, sealed sentence), both as text."""
    print_, key = _secrets(salt, signature)
    return print_, base64.b64encode(_crossed(sentence.encode(), key)).decode()


def find(sealed, salt, signatures):
    """The sentence that one of several signatures opens, or ""; `sealed` maps fingerprints to
    sealed sentences."""
    for signature in signatures:
        print_, key = _secrets(salt, signature)
        if print_ in sealed:
            return _crossed(base64.b64decode(sealed[print_]), key).decode()
    return ""


def _secrets(salt, signature):
    secret = hmac.digest(salt.encode(), signature, "sha256")
    return hmac.digest(secret, b"fingerprint", "sha256").hex()[:24], hmac.digest(
        secret, b"key", "sha256"
    )


def _crossed(text, key):
    """Bytes crossed with a stream that the key gives; done twice they are what they were."""
    return bytes(a ^ b for a, b in zip(text, hashlib.shake_256(key).digest(len(text))))
