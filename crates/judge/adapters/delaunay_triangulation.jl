# DelaunayTriangulation.jl: points and edges. `import Pkg; Pkg.add(["DelaunayTriangulation", "JSON"])`
using DelaunayTriangulation, JSON

for line in eachline()
    question = JSON.parse(line)
    points = [Tuple(Float64.(p)) for p in question["points"]]
    edges = Set((i + 1, j + 1) for (i, j) in question["edges"])
    answer = try
        t = triangulate(points; segments = isempty(edges) ? nothing : edges)
        Dict("triangles" => [collect(Int.(T)) .- 1 for T in each_solid_triangle(t)])
    catch error
        Dict("refused" => first(sprint(showerror, error), 200))
    end
    println(JSON.json(answer)); flush(stdout)
end
