(* The checker as an OCaml program. The mappings below are trusted: a type of Coq becomes one of OCaml or of Zarith.
   Integer is another name for Zarith's module Z, since the extracted program has a module Z of its own. *)
Require Import ZArith List Extraction ExtrOcamlBasic.
Require Import Check.

Extract Inlined Constant fst => "fst".
Extract Inlined Constant snd => "snd".
Extract Inductive nat => int [ "0" "succ" ] "(fun zero next n -> if n = 0 then zero () else next (n - 1))".

Extract Inductive positive => "Integer.t"
  [ "(fun p -> Integer.succ (Integer.shift_left p 1))" "(fun p -> Integer.shift_left p 1)" "Integer.one" ]
  "(fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)".
Extract Inductive Z => "Integer.t" [ "Integer.zero" "" "Integer.neg" ]
  "(fun zero positive negative z ->
     let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))".

Extract Inlined Constant Z.add => "Integer.add".
Extract Inlined Constant Z.sub => "Integer.sub".
Extract Inlined Constant Z.mul => "Integer.mul".
Extract Inlined Constant Z.eqb => "Integer.equal".
Extract Inlined Constant Z.leb => "Integer.leq".
Extract Inlined Constant Z.ltb => "Integer.lt".
Extract Inlined Constant Z.even => "Integer.is_even".
Extract Inlined Constant Z.compare =>
  "(fun x y -> let c = Integer.compare x y in if c < 0 then Lt else if c = 0 then Eq else Gt)".

(* The file also gets what these functions are made of in Coq's library. None of that is called. *)
(* `check` goes through a list of records by `take`. The program reads one after the other. *)
Extraction "build/checker.ml" judge_of start take finish.
