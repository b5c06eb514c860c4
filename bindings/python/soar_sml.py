# SPDX-License-Identifier: BSD-2-Clause
"""The client interface of Soar under its newer name; see Python_sml_ClientInterface."""
from Python_sml_ClientInterface import *  # noqa: F403
