"""startinpy: points. `pip install startinpy`"""
import startinpy
from lines import by_place, serve


def triangulate(question):
    result = startinpy.DT()
    result.snap_tolerance = 1e-300
    result.insert([[x, y, 0.0] for x, y in question["points"]])
    return by_place(question, [[result.points[v][:2] for v in t] for t in result.triangles])


serve("startinpy", triangulate)
