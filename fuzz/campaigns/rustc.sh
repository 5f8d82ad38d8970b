#!/bin/sh
# Stands before rustc where the fuzz targets are built (.cargo/config.toml), so that `cargo fuzz run -s none TARGET`, as it is
# typed, builds what a campaign runs.
#
# Counters are for the code under test. In the loops of big integers, of other programs and of readers of JSON they cost
# half of the time, and they make libFuzzer keep inputs that reach nothing new in this crate: crates of others, and the
# packages that draw, generate and judge, are compiled without them. What is generic is compiled, with counters, where it is used. Weighing comparisons costs more
# executions than it gains with generated inputs. Which assertions are compiled says Cargo.toml, and in how many units.
rustc=$1
shift

# The packages that are tested and the targets themselves keep the counters.
case " $* " in
*" sweep_cdt_draw "* | *" sweep_cdt_generate "* | *" sweep_cdt_testing "*) others=-Cpasses=sancov-module ;;
*" --crate-name sweep_cdt"* | *" fuzz_targets/"*) others= ;;
*) others=-Cpasses=sancov-module ;;
esac

# Each word goes from the front to the back, but for some.
words=$#
while [ "$words" -gt 0 ]; do
    word=$1
    shift
    words=$((words - 1))
    case $word in
    "$others" | -Cdebug-assertions | -Ccodegen-units=1) ;;
    -Cllvm-args=-sanitizer-coverage-trace-compares | -Cllvm-args=-sanitizer-coverage-stack-depth) ;;
    *) set -- "$@" "$word" ;;
    esac
done
exec "$rustc" "$@"
