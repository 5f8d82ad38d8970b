(* Reads a certificate (certificate.md), record by record, asks the proved checker, and says what it found.
   Exit status: 0 correct, 1 refused, 2 and all others: no verdict. *)
open Checker

exception Refused

let lines = ref 0

(* Each record goes to `take`. A line that is not as certificate.md says fits no pattern, or has a word that is no number or
   no point. *)
let judge channel rule =
  let words () = incr lines; String.split_on_char ' ' (input_line channel) in
  let integer = Integer.of_string in
  let ["sweep-cdt-certificate"; "3"] = words () in
  let ["exponent"; exponent] = words () in
  ignore (int_of_string exponent);
  let rec polygon outlines = function
    | "holes" :: l -> { outlines; holes = List.rev_map integer l } | r :: l -> polygon (integer r :: outlines) l in
  let domain = match words () with
    | ["domain"; "hull"] -> Hull | ["domain"; "even-odd"] -> EvenOdd | ["domain"; "nonzero"] -> NonZero
    | ["domain"; "polygons"] ->
      let ["polygons"; count] = words () in
      Polygons (List.init (int_of_string count) (fun _ -> let "outlines" :: l = words () in polygon [] l)) in
  let place = Hashtbl.create 1000 in
  let points = ref 0 and edges = ref 0 and triangles = ref 0 in
  let point word = Hashtbl.find place (int_of_string word) in
  let marks = Array.init 8 (fun m -> { mark_ab = m land 1 > 0; mark_bc = m land 2 > 0; mark_ca = m land 4 > 0 }) in
  let rec rings ab = function (* what stands after ab, and what stands after bc *)
    | [] -> ab, [] | "bc" :: l -> ab, List.map integer l | r :: l -> rings (integer r :: ab) l in
  let record = function
    | ["p"; x; y] ->
      let p = { zx = integer x; zy = integer y } in
      Hashtbl.add place !points p; incr points; NewPoint p
    | "e" :: line ->
      let edge_ring, from :: rest = match domain, line with
        | Polygons _, "-" :: l -> None, l | Polygons _, r :: l -> Some (integer r), l | _ -> None, line in
      let edge_to :: through = List.rev_map point rest in
      incr edges; NewEdge { edge_from = point from; edge_through = List.rev through; edge_to; edge_ring }
    | ["l"; a; b] -> NewLower { left_end = point a; right_end = point b }
    | "t" :: a :: b :: c :: m :: rest ->
      let value, (rings_ab, rings_bc) = match domain, rest with
        | Hull, [] -> Integer.zero, ([], []) | (EvenOdd | NonZero), [w] -> integer w, ([], [])
        | Polygons _, ("0" | "1" as w) :: "ab" :: l -> integer w, rings [] l
        | Polygons _, ("0" | "1" as w) :: ([] | "bc" :: _ as l) -> integer w, rings [] l in
      incr triangles;
      NewTriangle { corner_a = point a; corner_b = point b; corner_c = point c; marks = marks.(int_of_string m); value;
        rings_ab; rings_bc }
    | "f" :: l -> List.iter (fun n -> Hashtbl.remove place (int_of_string n)) l; Forget in
  let judge = judge_of domain in
  let rec run known = match words () with
    | ["end"] -> if finish domain judge known then () else raise Refused
    | line -> match take rule domain judge (record line) known with Some known -> run known | None -> raise Refused in
  run start;
  match words () with exception End_of_file -> domain, !points, !edges, !triangles | _ -> failwith "more"

let say status message = print_endline message; exit status

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 0x800000; space_overhead = 200 };
  let verdict path rule =
    let channel = if path = "-" then stdin else open_in_bin path in
    lines := 0;
    match judge channel rule with found -> close_in channel; Some found | exception Refused -> close_in channel; None in
  let report path rule =
    match verdict path rule with
    | Some (domain, points, edges, triangles) ->
      let tie = if rule then ", by the rule of the first corner" else ", whatever becomes of ties" in
      let inside = match domain with
        | Hull -> "" | EvenOdd -> "; their values are the interior by even-odd"
        | NonZero -> "; their values are the winding numbers"
        | Polygons _ -> "; their values are the interior of the polygons" in
      say 0 (Printf.sprintf "correct: %d triangles: the constrained Delaunay triangulation of %d points and %d edges%s%s"
        triangles points edges tie inside)
    | None ->
      let refused = Printf.sprintf "refused at line %d" !lines in
      if rule && path <> "-" && verdict path false <> None
      then say 1 "refused: a constrained Delaunay triangulation, but not by the rule of the first corner; --plain accepts it"
      else say 1 refused in
  let report path rule =
    try report path rule with
    | Sys_error m -> say 2 ("unreadable: " ^ m)
    | Failure _ | Invalid_argument _ | Match_failure _ | Not_found | End_of_file ->
      say 2 (Printf.sprintf "unreadable: line %d is not that of a certificate" !lines) in
  match Sys.argv with
  | [| _; path |] -> report path true
  | [| _; "--plain"; path |] -> report path false
  | _ -> say 2 "usage: check [--plain] FILE"
