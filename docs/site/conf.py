# The site by Sphinx: scripts/docs writes the pages that this finds. What belongs to this machine comes
# from its environment.
import os
import re
import sys

sys.path.insert(0, os.environ["TM_PYTHON"])

project = "tm"
copyright = "2026 the tm authors"
version = release = os.environ["TM_VERSION"]
extensions = ["breathe", "sphinx.ext.autodoc"]
root_doc = "index"
html_theme = "furo"
html_title = f"tm {release}"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_extra_path = ["extra"]
html_copy_source = html_show_sourcelink = html_show_sphinx = False
html_theme_options = {"navigation_with_keys": True}
smartquotes = False
default_role = "code"
highlight_language = "none"
# Colors of the others have too little contrast.
pygments_style = "bw"
nitpicky = False

breathe_projects = {"tm": os.environ["TM_DOXYGEN"]}
breathe_default_project = "tm"
breathe_show_include = False
cpp_index_common_prefix = ["transformesh::"]

autodoc_member_order = "bysource"
autodoc_preserve_defaults = True
# The module of bindings that holds everything is nobody's business.
add_module_names = False


def public_names(app, what, name, object_, options, signature, returns):
    return tuple(text and re.sub(r"transformesh\._transformesh\.", "", text) for text in (signature, returns))


def setup(app):
    app.connect("autodoc-process-signature", public_names)
