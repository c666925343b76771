# SPDX-License-Identifier: MIT
"""The wheel holds a library for one platform, and no code for one Python: py3-none-PLATFORM. SINEW_PLATFORM names the platform, which
build.sh takes from what the library needs (wheel_tag.py), or that of a library that was cross-compiled."""
import os

from setuptools import Distribution, setup
from wheel.bdist_wheel import bdist_wheel


class PlatformDistribution(Distribution):
    def has_ext_modules(self):
        return True


class PlatformWheel(bdist_wheel):
    def get_tag(self):
        return "py3", "none", os.environ.get("SINEW_PLATFORM") or super().get_tag()[2]


setup(distclass=PlatformDistribution, cmdclass={"bdist_wheel": PlatformWheel})
