// CGAL on a data set, as testing/src/binary.rs describes it: `cgal INPUT CALLS [ANSWER]` triangulates it so many times
// and prints, for each input each time, a line with nanoseconds and bytes; `cgal` prints its version.
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

// Triangulates all inputs.
static void run(const char* path, std::FILE* answer) {
    std::FILE* input = std::fopen(path, "rb");
    if (!input) std::exit(1);
    for (auto inputs = read<std::uint64_t>(input, 1)[0]; inputs > 0; --inputs) {
        Points points;
        std::vector<std::pair<std::size_t, std::size_t>> edges;
        {
            const auto sizes = read<std::uint64_t>(input, 2);
            const auto coordinates = read<double>(input, 2 * sizes[0]);
            const auto ends = read<std::uint64_t>(input, 2 * sizes[1]);
            for (std::size_t i = 0; i < sizes[0]; ++i)
                points.emplace_back(coordinates[2 * i], coordinates[2 * i + 1]);
            for (std::size_t i = 0; i < sizes[1]; ++i) edges.emplace_back(ends[2 * i], ends[2 * i + 1]);
        }
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
    std::fclose(input);
}

int main(int count, char** words) {
    if (count < 2) return std::puts(CGAL_VERSION_STR) < 0;
    if (count < 3) return 1;
    std::FILE* answer = count > 3 ? std::fopen(words[3], "wb") : nullptr;
    if (count > 3 && !answer) return 1;
    for (long calls = std::atol(words[2]); calls > 0; --calls) run(words[1], calls == 1 ? answer : nullptr);
    if (answer) std::fclose(answer);
}
