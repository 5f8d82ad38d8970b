#!/bin/sh
# Stands before rustc (RUSTC_WRAPPER) when the fuzz targets are built: crates of others are compiled as usual, without the
# counters of libFuzzer.
#
# Counters are for the code under test. In the loops of big integers, of other programs and of readers of JSON they cost
# half of the time, and they make libFuzzer keep inputs that reach nothing new in this crate. What is generic is compiled,
# with counters, where it is used.
rustc=$1
shift

# The packages of this repository and the targets themselves keep the counters.
case " $* " in
*" --crate-name sweep_cdt"* | *" fuzz_targets/"*) exec "$rustc" "$@" ;;
esac

# Each word goes from the front to the back, but for one.
words=$#
while [ "$words" -gt 0 ]; do
    word=$1
    shift
    words=$((words - 1))
    [ "$word" = -Cpasses=sancov-module ] || set -- "$@" "$word"
done
exec "$rustc" "$@"
