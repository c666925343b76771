# SPDX-License-Identifier: MIT
"""What scripts/declarations.py is made of: the C headers as data, and a writer a language."""
