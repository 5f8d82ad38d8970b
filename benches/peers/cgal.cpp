// CGAL on a data set, as testing/src/binary.rs describes it: `cgal INPUT CALLS [ANSWER]` triangulates it so many times
// and prints, for each input each time, a line with nanoseconds and bytes; `cgal` prints its version. `cgal INPUT edits`
// triangulates the points of the first input, and edits copies of that: see `edits`.
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/version.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using Constrained = CGAL::Constrained_Delaunay_triangulation_2<Kernel>;
using Points = std::vector<Kernel::Point_2>;

template <typename T> static std::vector<T> read(std::FILE* file, std::size_t count) {
    std::vector<T> list(count);
    if (std::fread(list.data(), sizeof(T), count, file) != count) std::exit(1);
    return list;
}

// The largest resident set so far, in bytes.
static long long peak() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind("VmHWM:", 0) == 0) return 1024 * std::atoll(line.c_str() + 6);
    return 0;
}

// Times a call.
template <typename F> static void timed(F call) {
    std::ofstream("/proc/self/clear_refs") << 5 << std::flush;
    const long long before = peak();
    const auto start = std::chrono::steady_clock::now();
    call();
    const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
    std::printf("%.0f %lld\n", time.count(), peak() - before);
}

template <typename T> static void write(const T& result, const Points& points, std::FILE* answer) {
    if (!answer) return;
    std::map<Kernel::Point_2, std::uint64_t> places;
    for (std::size_t i = 0; i < points.size(); ++i) places[points[i]] = i;
    const std::uint64_t count = result.number_of_faces();
    std::fwrite(&count, sizeof count, 1, answer);
    for (auto face = result.finite_faces_begin(); face != result.finite_faces_end(); ++face)
        for (int i = 0; i < 3; ++i)
            std::fwrite(&places.at(face->vertex(i)->point()), sizeof count, 1, answer);
}

struct Input {
    Points points;
    std::vector<std::pair<std::size_t, std::size_t>> edges;

    explicit Input(std::FILE* file) {
        const auto sizes = read<std::uint64_t>(file, 2);
        const auto coordinates = read<double>(file, 2 * sizes[0]);
        const auto ends = read<std::uint64_t>(file, 2 * sizes[1]);
        for (std::size_t i = 0; i < sizes[0]; ++i) points.emplace_back(coordinates[2 * i], coordinates[2 * i + 1]);
        for (std::size_t i = 0; i < sizes[1]; ++i) edges.emplace_back(ends[2 * i], ends[2 * i + 1]);
    }
};

// Times edits, and prints how many triangles there are then. Of two inputs after the first, points come one by one, each
// from the triangle of the last one, and go again; of the next, edges between points of the first; of the others, points
// all at once.
static void edits(std::FILE* input) {
    const auto count = read<std::uint64_t>(input, 1)[0];
    const Input first(input);
    Constrained start;
    start.insert(first.points.begin(), first.points.end());
    for (std::uint64_t i = 1; i < count; ++i) {
        const Input next(input);
        Constrained edited = start;
        if (!next.edges.empty()) {
            std::map<Kernel::Point_2, Constrained::Vertex_handle> vertices;
            for (auto v : edited.finite_vertex_handles()) vertices[v->point()] = v;
            std::vector<std::pair<Constrained::Vertex_handle, Constrained::Vertex_handle>> ends;
            for (const auto& [a, b] : next.edges)
                ends.emplace_back(vertices.at(first.points[a]), vertices.at(first.points[b]));
            timed([&] { for (const auto& [a, b] : ends) edited.insert_constraint(a, b); });
        } else if (i > 2) {
            timed([&] { edited.insert(next.points.begin(), next.points.end()); });
        } else {
            std::vector<Constrained::Vertex_handle> made;
            timed([&] {
                Constrained::Face_handle near;
                for (const auto& point : next.points) near = made.emplace_back(edited.insert(point, near))->face();
            });
            std::printf("%zu\n", static_cast<std::size_t>(edited.number_of_faces()));
            timed([&] { for (auto v = made.rbegin(); v != made.rend(); ++v) edited.remove(*v); });
        }
        std::printf("%zu\n", static_cast<std::size_t>(edited.number_of_faces()));
    }
}

// Triangulates all inputs.
static void run(std::FILE* input, std::FILE* answer) {
    for (auto inputs = read<std::uint64_t>(input, 1)[0]; inputs > 0; --inputs) {
        const auto [points, edges] = Input(input);
        if (edges.empty()) {
            Delaunay result;
            timed([&] { result.insert(points.begin(), points.end()); });
            write(result, points, answer);
        } else {
            Constrained result;
            timed([&] { result.insert_constraints(points.begin(), points.end(), edges.begin(), edges.end()); });
            write(result, points, answer);
        }
    }
}

int main(int count, char** words) {
    if (count < 2) return std::puts(CGAL_VERSION_STR) < 0;
    if (count < 3) return 1;
    std::FILE* answer = count > 3 ? std::fopen(words[3], "wb") : nullptr;
    if (count > 3 && !answer) return 1;
    std::FILE* input = std::fopen(words[1], "rb");
    if (!input) return 1;
    if (std::string(words[2]) == "edits") edits(input);
    for (long calls = std::atol(words[2]); calls > 0; --calls) {
        std::rewind(input);
        run(input, calls == 1 ? answer : nullptr);
    }
    std::fclose(input);
    if (answer) std::fclose(answer);
}
