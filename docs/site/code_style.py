"""Colours of code on a light ground, each of which is readable on it."""

from pygments.styles.xcode import XcodeStyle


class CodeStyle(XcodeStyle):
    background_color = "#f8f8f8"  # other than that of the page
