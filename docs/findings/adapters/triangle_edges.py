"""Triangle: points with edges. `pip install triangle`"""
import triangle
from lines import serve


def triangulate(question):
    given = {"vertices": question["points"]}
    if question["edges"]:
        given["segments"] = question["edges"]
    return triangle.triangulate(given, "pc" if question["edges"] else "").get("triangles", [])


serve("triangle", triangulate, RuntimeError)
