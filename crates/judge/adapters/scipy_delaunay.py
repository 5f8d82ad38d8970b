"""SciPy (Qhull): points. `pip install scipy`"""
import json
import sys

import scipy
from scipy.spatial import Delaunay, QhullError

for line in sys.stdin:
    question = json.loads(line)
    try:
        answer = {"triangles": Delaunay(question["points"]).simplices.tolist()}
    except (QhullError, ValueError) as error:
        answer = {"refused": str(error).split("\n")[0]}
    print(json.dumps(answer | {"program": "scipy " + scipy.__version__}), flush=True)
