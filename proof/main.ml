(* Reads a certificate (certificate.md), asks the proved checker, and says what it found.
   Exit status: 0 correct, 1 refused, 2 and all others: no verdict. *)
open Checker

let lines = ref 0

(* A line that is not as certificate.md says fits no pattern, or has a word that is no number or no point. *)
let read channel =
  let words () = incr lines; String.split_on_char ' ' (input_line channel) in
  let count name = match words () with [n; count] when n = name -> int_of_string count in
  let list count item = List.init count (fun _ -> item (words ())) in
  let integer = Integer.of_string in
  let ["sweep-cdt-certificate"; "2"] = words () in
  ignore (count "exponent");
  let rec polygon outlines = function
    | "holes" :: l -> { outlines; holes = List.rev_map integer l } | r :: l -> polygon (integer r :: outlines) l in
  let domain = match words () with
    | ["domain"; "hull"] -> Hull | ["domain"; "even-odd"] -> EvenOdd | ["domain"; "nonzero"] -> NonZero
    | ["domain"; "polygons"] -> Polygons (list (count "polygons") (fun ("outlines" :: l) -> polygon [] l)) in
  let points = list (count "points") (fun [x; y] -> { zx = integer x; zy = integer y }) in
  let place = Array.of_list points in
  let point word = place.(int_of_string word) in
  let edges = list (count "edges") (fun line ->
    let edge_ring, from :: rest = match domain, line with
      | Polygons _, "-" :: l -> None, l | Polygons _, r :: l -> Some (integer r), l | _ -> None, line in
    let edge_to :: through = List.rev_map point rest in
    { edge_from = point from; edge_through = List.rev through; edge_to; edge_ring }) in
  let lower = list (match count "lower" with 0 -> 0 | sides -> sides + 1) (fun [a] -> point a) in
  let marks = Array.init 8 (fun m -> { mark_ab = m land 1 > 0; mark_bc = m land 2 > 0; mark_ca = m land 4 > 0 }) in
  let triangles = list (count "triangles") (fun (a :: b :: c :: m :: rest) ->
    let rec rings ab = function (* what stands after ab, and what stands after bc *)
      | [] -> ab, [] | "bc" :: l -> ab, List.map integer l | r :: l -> rings (integer r :: ab) l in
    let value, (rings_ab, rings_bc) = match domain, rest with
      | Hull, [] -> Integer.zero, ([], []) | (EvenOdd | NonZero), [w] -> integer w, ([], [])
      | Polygons _, ("0" | "1" as w) :: "ab" :: l -> integer w, rings [] l
      | Polygons _, ("0" | "1" as w) :: ([] | "bc" :: _ as l) -> integer w, rings [] l in
    { corner_a = point a; corner_b = point b; corner_c = point c; marks = marks.(int_of_string m); value;
      rings_ab; rings_bc }) in
  let ["end"] = words () in
  match words () with exception End_of_file -> { domain; points; edges; lower; triangles } | _ -> failwith "more"

let say status message = print_endline message; exit status

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 0x800000; space_overhead = 200 };
  let judge plain path =
    let k = try read (open_in_bin path) with
      | Sys_error m -> say 2 ("unreadable: " ^ m)
      | Failure _ | Invalid_argument _ | Match_failure _ | End_of_file ->
        say 2 (Printf.sprintf "unreadable: line %d is not that of a certificate" !lines) in
    let what = Printf.sprintf "%d triangles: the constrained Delaunay triangulation of %d points and %d edges"
      (List.length k.triangles) (List.length k.points) (List.length k.edges) in
    let tie = if plain then ", whatever becomes of ties" else ", by the rule of the first corner" in
    let inside = match k.domain with
      | Hull -> "" | EvenOdd -> "; their values are the interior by even-odd"
      | NonZero -> "; their values are the winding numbers"
      | Polygons _ -> "; their values are the interior of the polygons" in
    if check (not plain) k then say 0 ("correct: " ^ what ^ tie ^ inside)
    else if not plain && check false k then
      say 1 "refused: a constrained Delaunay triangulation, but not by the rule of the first corner; --plain accepts it"
    else say 1 "refused" in
  match Sys.argv with
  | [| _; path |] -> judge false path
  | [| _; "--plain"; path |] -> judge true path
  | _ -> say 2 "usage: check [--plain] FILE"
