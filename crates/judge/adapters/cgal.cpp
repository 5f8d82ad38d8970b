// CGAL: points and edges. `apt-get install libcgal-dev`, `g++ -O2 cgal.cpp -lgmp -o cgal`
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <cstdlib>
#include <iostream>
using K = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, K>;
using Data = CGAL::Triangulation_data_structure_2<Vertex, CGAL::Constrained_triangulation_face_base_2<K>>;
using Cdt = CGAL::Constrained_Delaunay_triangulation_2<K, Data, CGAL::No_constraint_intersection_requiring_constructions_tag>;

// The numbers of a list of lists.
std::vector<double> numbers(const std::string& line, const std::string& name) {
    std::vector<double> found;
    const char* at = line.c_str() + line.find('[', line.find("\"" + name + "\":"));
    for (int depth = 0; depth || found.empty() && *at == '[';) {
        char* end = const_cast<char*>(at) + 1;
        if (*at == '[') ++depth;
        else if (*at == ']') --depth;
        else if (*at != ',' && *at != ' ') found.push_back(std::strtod(at, &end));
        at = end;
    }
    return found;
}

int main() {
    for (std::string line; std::getline(std::cin, line);) {
        auto points = numbers(line, "points"), edges = numbers(line, "edges");
        Cdt cdt;
        std::vector<Cdt::Vertex_handle> at;
        for (size_t k = 0; k < points.size(); k += 2) {
            at.push_back(cdt.insert(K::Point_2(points[k], points[k + 1])));
            at.back()->info() = k / 2;
        }
        for (size_t k = 0; k < edges.size(); k += 2) cdt.insert_constraint(at[edges[k]], at[edges[k + 1]]);
        std::string triangles;
        for (auto f : cdt.finite_face_handles()) {
            triangles += triangles.empty() ? "[" : ",[";
            for (int k = 0; k < 3; ++k) triangles += (k ? "," : "") + std::to_string(f->vertex(k)->info());
            triangles += "]";
        }
        std::cout << "{\"triangles\":[" << triangles << "],\"program\":\"CGAL " CGAL_VERSION_STR "\"}" << std::endl;
    }
}
