(* Reads a certificate (certificate.md), asks the proved checker, and says what it found.
   Exit status: 0 correct, 1 refused, 2 and all others: no verdict. *)
open Checker

let read channel =
  let words () = String.split_on_char ' ' (input_line channel) in
  let fail what = failwith ("not a certificate: " ^ what) in
  let many name = match words () with [n; count] when n = name -> int_of_string count | _ -> fail name in
  let list count item =
    let rec more l n = if n = 0 then List.rev l else more (item () :: l) (n - 1) in
    if count < 0 then fail "a count below 0" else more [] count in
  let header = words () in
  if header <> ["sweep-cdt-certificate"; "1"] then fail "header";
  ignore (many "exponent");
  let domain = match words () with
    | ["domain"; "hull"] -> Hull | ["domain"; "even-odd"] -> EvenOdd | ["domain"; "nonzero"] -> NonZero
    | _ -> fail "domain" in
  let count = many "points" in
  let points = list count (fun () -> match words () with
    | [x; y] -> { zx = Integer.of_string x; zy = Integer.of_string y } | _ -> fail "a point") in
  let place = Array.of_list points in
  let point word = place.(int_of_string word) in
  let edges = list (many "edges") (fun () -> match words () with
    | a :: (_ :: _ as rest) -> (match List.rev_map point rest with
      | b :: through -> { edge_from = point a; edge_through = List.rev through; edge_to = b } | [] -> fail "an edge")
    | _ -> fail "an edge") in
  let sides = many "lower" in
  let lower = list (if sides = 0 then 0 else sides + 1) (fun () -> match words () with
    | [a] -> point a | _ -> fail "a point of the lower hull") in
  let marks = Array.init 8 (fun m -> { mark_ab = m land 1 > 0; mark_bc = m land 2 > 0; mark_ca = m land 4 > 0 }) in
  let triangle a b c m value =
    { corner_a = point a; corner_b = point b; corner_c = point c; marks = marks.(int_of_string m); value } in
  let triangles = list (many "triangles") (fun () -> match domain, words () with
    | Hull, [a; b; c; m] -> triangle a b c m Integer.zero
    | (EvenOdd | NonZero), [a; b; c; m; value] -> triangle a b c m (Integer.of_string value)
    | _ -> fail "a triangle") in
  if words () <> ["end"] || (try ignore (input_char channel); true with End_of_file -> false) then fail "end";
  { domain; points; edges; lower; triangles }

let say status message = print_endline message; exit status

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 0x100000; space_overhead = 200 };
  let judge plain path =
    let k = try read (open_in_bin path) with
      | Sys_error m | Failure m | Invalid_argument m -> say 2 ("unreadable: " ^ m)
      | End_of_file -> say 2 "unreadable: the file ends too early" in
    let what = Printf.sprintf "%d triangles: the constrained Delaunay triangulation of %d points and %d edges"
      (List.length k.triangles) (List.length k.points) (List.length k.edges) in
    let tie = if plain then ", whatever becomes of ties" else ", by the rule of the first corner" in
    let inside = match k.domain with
      | Hull -> "" | EvenOdd -> "; their values are the interior by even-odd"
      | NonZero -> "; their values are the winding numbers" in
    if check (not plain) k then say 0 ("correct: " ^ what ^ tie ^ inside)
    else if not plain && check false k then
      say 1 "refused: a constrained Delaunay triangulation, but not by the rule of the first corner; --plain accepts it"
    else say 1 "refused" in
  match Sys.argv with
  | [| _; path |] -> judge false path
  | [| _; "--plain"; path |] -> judge true path
  | _ -> say 2 "usage: check [--plain] FILE"
