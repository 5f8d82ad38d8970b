"""SciPy (Qhull): points. `pip install scipy`"""
from lines import serve
from scipy.spatial import Delaunay, QhullError

serve("scipy", lambda q: Delaunay(q["points"]).simplices, (QhullError, ValueError))
