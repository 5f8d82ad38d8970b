// CGAL on the input that comes from standard input: two counts of 64 bits, coordinates, indices. Prints the
// seconds of three runs.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;

template <typename T> static std::vector<T> read(std::size_t count) {
    std::vector<T> list(count);
    if (std::fread(list.data(), sizeof(T), count, stdin) != count) std::exit(1);
    return list;
}

int main() {
    const auto sizes = read<std::uint64_t>(2);
    const auto coordinates = read<double>(2 * sizes[0]);
    const auto ends = read<std::uint64_t>(2 * sizes[1]);
    std::vector<Kernel::Point_2> points;
    for (std::size_t i = 0; i < sizes[0]; ++i) points.emplace_back(coordinates[2 * i], coordinates[2 * i + 1]);
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t i = 0; i < sizes[1]; ++i) edges.emplace_back(ends[2 * i], ends[2 * i + 1]);

    for (int run = 0; run < 3; ++run) {
        const auto start = std::chrono::steady_clock::now();
        std::size_t faces = 0;
        if (edges.empty()) {
            const Delaunay result(points.begin(), points.end());
            faces = result.number_of_faces();
        } else {
            Constrained result;
            result.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end());
            faces = result.number_of_faces();
        }
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        if (faces == 0 && points.size() > 1000000000) return 1;
        std::printf("%.9f\n", time.count());
    }
}
