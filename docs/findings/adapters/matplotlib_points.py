"""Matplotlib (Qhull): points. `pip install matplotlib`"""
from lines import serve
from matplotlib.tri import Triangulation

serve("matplotlib", lambda q: Triangulation(*zip(*q["points"])).triangles, (RuntimeError, ValueError))
