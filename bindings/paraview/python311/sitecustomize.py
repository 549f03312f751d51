"""ParaView 5.11 loads no plugin in Python under Python 3.11, which has no inspect.getargspec: here it is again.

Python imports this file at its start where its folder is on PYTHONPATH.
"""

import inspect

if not hasattr(inspect, "getargspec"):
    inspect.getargspec = inspect.getfullargspec  # ParaView asks for .args alone
