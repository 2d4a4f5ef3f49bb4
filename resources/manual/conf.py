"""Sphinx configuration of the manual. stage.py writes the folder that Sphinx reads; the build passes
the version (-D release=)."""

project = "HuNavSim Desktop"
author = "HuNavSim Desktop developers"
copyright = "HuNavSim Desktop developers, MIT licence"
extensions = ["myst_parser"]
myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence", "deflist"]
smartquotes = False  # they would turn the dashes of options into one
html_theme = "furo"
html_title = "HuNavSim Desktop"
html_show_sphinx = False
html_copy_source = False
html_static_path = []
language = "en"
suppress_warnings = ["misc.highlighting_failure"]  # console blocks with the output of commands
