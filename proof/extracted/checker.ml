
(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

(** val option_map : ('a1 -> 'a2) -> 'a1 option -> 'a2 option **)

let option_map f = function
| Some a -> Some (f a)
| None -> None

(** val app : 'a1 list -> 'a1 list -> 'a1 list **)

let rec app l m =
  match l with
  | [] -> m
  | a :: l1 -> a :: (app l1 m)

type comparison =
| Eq
| Lt
| Gt

module Coq__1 = struct
 (** val add : int -> int -> int **)
 let rec add n m =
   (fun zero next n -> if n = 0 then zero () else next (n - 1))
     (fun _ -> m)
     (fun p -> succ (add p m))
     n
end
include Coq__1

(** val eqb : bool -> bool -> bool **)

let eqb b1 b2 =
  if b1 then b2 else if b2 then false else true

module type EqLtLe =
 sig
  type t
 end

module MakeOrderTac =
 functor (O:EqLtLe) ->
 functor (P:sig
 end) ->
 struct
 end

module Pos =
 struct
  (** val succ : Integer.t -> Integer.t **)

  let rec succ x =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p -> (fun p -> Integer.shift_left p 1) (succ p))
      (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1)) p)
      (fun _ -> (fun p -> Integer.shift_left p 1) Integer.one)
      x

  (** val add : Integer.t -> Integer.t -> Integer.t **)

  let rec add x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> (fun p -> Integer.shift_left p 1) (add_carry p q))
        (fun q -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add p q))
        (fun _ -> (fun p -> Integer.shift_left p 1) (succ p))
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add p q))
        (fun q -> (fun p -> Integer.shift_left p 1) (add p q))
        (fun _ -> (fun p -> Integer.succ (Integer.shift_left p 1)) p)
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> (fun p -> Integer.shift_left p 1) (succ q))
        (fun q -> (fun p -> Integer.succ (Integer.shift_left p 1))
        q)
        (fun _ -> (fun p -> Integer.shift_left p 1) Integer.one)
        y)
      x

  (** val add_carry : Integer.t -> Integer.t -> Integer.t **)

  and add_carry x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add_carry p q))
        (fun q -> (fun p -> Integer.shift_left p 1) (add_carry p q))
        (fun _ -> (fun p -> Integer.succ (Integer.shift_left p 1)) (succ p))
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> (fun p -> Integer.shift_left p 1) (add_carry p q))
        (fun q -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (add p q))
        (fun _ -> (fun p -> Integer.shift_left p 1) (succ p))
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> (fun p -> Integer.succ (Integer.shift_left p 1))
        (succ q))
        (fun q -> (fun p -> Integer.shift_left p 1) (succ q))
        (fun _ -> (fun p -> Integer.succ (Integer.shift_left p 1))
        Integer.one)
        y)
      x

  (** val pred_double : Integer.t -> Integer.t **)

  let rec pred_double x =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1))
      ((fun p -> Integer.shift_left p 1) p))
      (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1))
      (pred_double p))
      (fun _ -> Integer.one)
      x

  (** val mul : Integer.t -> Integer.t -> Integer.t **)

  let rec mul x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p -> add y ((fun p -> Integer.shift_left p 1) (mul p y)))
      (fun p -> (fun p -> Integer.shift_left p 1) (mul p y))
      (fun _ -> y)
      x

  (** val compare_cont :
      comparison -> Integer.t -> Integer.t -> comparison **)

  let rec compare_cont r x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> compare_cont r p q)
        (fun q -> compare_cont Gt p q)
        (fun _ -> Gt)
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> compare_cont Lt p q)
        (fun q -> compare_cont r p q)
        (fun _ -> Gt)
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> Lt)
        (fun _ -> Lt)
        (fun _ -> r)
        y)
      x

  (** val compare : Integer.t -> Integer.t -> comparison **)

  let compare =
    compare_cont Eq

  (** val eqb : Integer.t -> Integer.t -> bool **)

  let rec eqb p q =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p0 ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q0 -> eqb p0 q0)
        (fun _ -> false)
        (fun _ -> false)
        q)
      (fun p0 ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> false)
        (fun q0 -> eqb p0 q0)
        (fun _ -> false)
        q)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> false)
        (fun _ -> false)
        (fun _ -> true)
        q)
      p
 end

module Z =
 struct
  (** val double : Integer.t -> Integer.t **)

  let double x =
    (fun zero positive negative z ->
     let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))
      (fun _ -> Integer.zero)
      (fun p -> ((fun p -> Integer.shift_left p 1) p))
      (fun p -> Integer.neg ((fun p -> Integer.shift_left p 1) p))
      x

  (** val succ_double : Integer.t -> Integer.t **)

  let succ_double x =
    (fun zero positive negative z ->
     let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))
      (fun _ -> Integer.one)
      (fun p -> ((fun p -> Integer.succ (Integer.shift_left p 1))
      p))
      (fun p -> Integer.neg (Pos.pred_double p))
      x

  (** val pred_double : Integer.t -> Integer.t **)

  let pred_double x =
    (fun zero positive negative z ->
     let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))
      (fun _ -> Integer.neg Integer.one)
      (fun p -> (Pos.pred_double p))
      (fun p -> Integer.neg ((fun p -> Integer.succ (Integer.shift_left p 1))
      p))
      x

  (** val pos_sub : Integer.t -> Integer.t -> Integer.t **)

  let rec pos_sub x y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> double (pos_sub p q))
        (fun q -> succ_double (pos_sub p q))
        (fun _ -> ((fun p -> Integer.shift_left p 1) p))
        y)
      (fun p ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> pred_double (pos_sub p q))
        (fun q -> double (pos_sub p q))
        (fun _ -> (Pos.pred_double p))
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun q -> Integer.neg ((fun p -> Integer.shift_left p 1) q))
        (fun q -> Integer.neg (Pos.pred_double q))
        (fun _ -> Integer.zero)
        y)
      x

  (** val opp : Integer.t -> Integer.t **)

  let opp x =
    (fun zero positive negative z ->
     let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))
      (fun _ -> Integer.zero)
      (fun x0 -> Integer.neg x0)
      (fun x0 -> x0)
      x
 end

(** val rev_append : 'a1 list -> 'a1 list -> 'a1 list **)

let rec rev_append l l' =
  match l with
  | [] -> l'
  | a :: l0 -> rev_append l0 (a :: l')

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t0 -> fold_left f t0 (f a0 b)

(** val goes_first :
    ('a1 -> 'a1 -> comparison) -> bool -> 'a1 -> 'a1 -> bool **)

let goes_first compare1 up x y =
  match compare1 x y with
  | Eq -> true
  | Lt -> up
  | Gt -> negb up

(** val merge :
    ('a1 -> 'a1 -> comparison) -> bool -> 'a1 list -> 'a1 list -> 'a1 list ->
    'a1 list **)

let rec merge compare1 up l1 l2 acc =
  match l1 with
  | [] -> rev_append l2 acc
  | x :: t1 ->
    (match l2 with
     | [] -> rev_append l1 acc
     | y :: t2 ->
       if goes_first compare1 up x y
       then merge compare1 up t1 l2 (x :: acc)
       else merge compare1 up l1 t2 (y :: acc))

(** val merge_pairs :
    ('a1 -> 'a1 -> comparison) -> bool -> 'a1 list list -> 'a1 list list ->
    'a1 list list **)

let rec merge_pairs compare1 up ls acc =
  match ls with
  | [] -> acc
  | a :: l ->
    (match l with
     | [] -> (rev_append a []) :: acc
     | b :: r -> merge_pairs compare1 up r ((merge compare1 up a b []) :: acc))

(** val merge_all :
    ('a1 -> 'a1 -> comparison) -> int -> bool -> 'a1 list list -> 'a1 list **)

let rec merge_all compare1 rounds up ls =
  (fun zero next n -> if n = 0 then zero () else next (n - 1))
    (fun _ ->
    match ls with
    | [] -> []
    | a :: r ->
      (match r with
       | [] -> if up then a else rev_append a []
       | _ :: _ -> fold_left (fun acc l -> rev_append l acc) r a))
    (fun n ->
    match ls with
    | [] -> []
    | a :: l ->
      (match l with
       | [] -> if up then a else rev_append a []
       | _ :: _ ->
         merge_all compare1 n (negb up) (merge_pairs compare1 up ls [])))
    rounds

(** val singles : 'a1 list -> 'a1 list list -> 'a1 list list **)

let rec singles l acc =
  match l with
  | [] -> acc
  | x :: r -> singles r ((x :: []) :: acc)

(** val sort : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list **)

let sort compare1 l =
  merge_all compare1 (succ (succ (succ (succ (succ (succ (succ (succ (succ
    (succ (succ (succ (succ (succ (succ (succ (succ (succ (succ (succ (succ
    (succ (succ (succ (succ (succ (succ (succ (succ (succ (succ (succ (succ
    (succ (succ (succ (succ (succ (succ (succ
    0)))))))))))))))))))))))))))))))))))))))) true (singles l [])

(** val distinct :
    ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> 'a1 list **)

let rec distinct compare1 l acc =
  match l with
  | [] -> acc
  | x :: r ->
    (match acc with
     | [] -> distinct compare1 r (x :: [])
     | y :: _ ->
       (match compare1 x y with
        | Eq -> distinct compare1 r acc
        | _ -> distinct compare1 r (x :: acc)))

(** val equal : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> bool **)

let rec equal compare1 l m =
  match l with
  | [] -> (match m with
           | [] -> true
           | _ :: _ -> false)
  | x :: l' ->
    (match m with
     | [] -> false
     | y :: m' ->
       (match compare1 x y with
        | Eq -> equal compare1 l' m'
        | _ -> false))

(** val same_set :
    ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> bool **)

let same_set compare1 l m =
  equal compare1 (distinct compare1 (sort compare1 l) [])
    (distinct compare1 (sort compare1 m) [])

(** val ascending : ('a1 -> 'a1 -> comparison) -> 'a1 -> 'a1 list -> bool **)

let rec ascending compare1 x = function
| [] -> true
| y :: r ->
  (match compare1 x y with
   | Lt -> ascending compare1 y r
   | _ -> false)

(** val all_ascending : ('a1 -> 'a1 -> comparison) -> 'a1 list -> bool **)

let all_ascending compare1 = function
| [] -> true
| x :: r -> ascending compare1 x r

(** val same_set_once :
    ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> bool **)

let same_set_once compare1 l m =
  let o = sort compare1 m in
  (&&) (all_ascending compare1 o)
    (equal compare1 (distinct compare1 (sort compare1 l) [])
      (rev_append o []))

(** val apart :
    ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> 'a1 list -> 'a1
    list -> 'a1 list * 'a1 list **)

let rec apart compare1 l m left right =
  match l with
  | [] -> (left, (rev_append m right))
  | x :: l' ->
    let rec beside m0 right0 =
      match m0 with
      | [] -> ((rev_append l left), right0)
      | y :: m' ->
        (match compare1 x y with
         | Eq -> apart compare1 l' m' left right0
         | Lt -> beside m' (y :: right0)
         | Gt -> apart compare1 l' m0 (x :: left) right0)
    in beside m right

(** val cancel :
    ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> 'a1 list * 'a1 list **)

let cancel compare1 l m =
  apart compare1 (distinct compare1 (sort compare1 l) [])
    (distinct compare1 (sort compare1 m) []) [] []

type 'x compare0 =
| LT
| EQ
| GT

module type OrderedType =
 sig
  type t

  val compare : t -> t -> t compare0

  val eq_dec : t -> t -> bool
 end

module OrderedTypeFacts =
 functor (O:OrderedType) ->
 struct
  module TO =
   struct
    type t = O.t
   end

  module IsTO =
   struct
   end

  module OrderTac = MakeOrderTac(TO)(IsTO)

  (** val eq_dec : O.t -> O.t -> bool **)

  let eq_dec =
    O.eq_dec

  (** val lt_dec : O.t -> O.t -> bool **)

  let lt_dec x y =
    match O.compare x y with
    | LT -> true
    | _ -> false

  (** val eqb : O.t -> O.t -> bool **)

  let eqb x y =
    if eq_dec x y then true else false
 end

module KeyOrderedType =
 functor (O:OrderedType) ->
 struct
  module MO = OrderedTypeFacts(O)
 end

module PositiveOrderedTypeBits =
 struct
  type t = Integer.t

  (** val compare : t -> t -> Integer.t compare0 **)

  let rec compare p y =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun p0 ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun p1 -> compare p0 p1)
        (fun _ -> GT)
        (fun _ -> GT)
        y)
      (fun p0 ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> LT)
        (fun p1 -> compare p0 p1)
        (fun _ -> LT)
        y)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> LT)
        (fun _ -> GT)
        (fun _ -> EQ)
        y)
      p

  (** val eq_dec : Integer.t -> Integer.t -> bool **)

  let eq_dec x y =
    match Pos.compare x y with
    | Eq -> true
    | _ -> false
 end

(** val append : Integer.t -> Integer.t -> Integer.t **)

let rec append i j =
  (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
    (fun ii -> (fun p -> Integer.succ (Integer.shift_left p 1))
    (append ii j))
    (fun ii -> (fun p -> Integer.shift_left p 1) (append ii j))
    (fun _ -> j)
    i

module PositiveMap =
 struct
  module E = PositiveOrderedTypeBits

  module ME = KeyOrderedType(E)

  type key = Integer.t

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  (** val empty : 'a1 t **)

  let empty =
    Leaf

  (** val is_empty : 'a1 t -> bool **)

  let rec is_empty = function
  | Leaf -> true
  | Node (l, o, r) ->
    (match o with
     | Some _ -> false
     | None -> (&&) (is_empty l) (is_empty r))

  (** val find : key -> 'a1 t -> 'a1 option **)

  let rec find i = function
  | Leaf -> None
  | Node (l, o, r) ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
       (fun ii -> find ii r)
       (fun ii -> find ii l)
       (fun _ -> o)
       i)

  (** val mem : key -> 'a1 t -> bool **)

  let rec mem i = function
  | Leaf -> false
  | Node (l, o, r) ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
       (fun ii -> mem ii r)
       (fun ii -> mem ii l)
       (fun _ -> match o with
                 | Some _ -> true
                 | None -> false)
       i)

  (** val add : key -> 'a1 -> 'a1 t -> 'a1 t **)

  let rec add i v = function
  | Leaf ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
       (fun ii -> Node (Leaf, None, (add ii v Leaf)))
       (fun ii -> Node ((add ii v Leaf), None, Leaf))
       (fun _ -> Node (Leaf, (Some v), Leaf))
       i)
  | Node (l, o, r) ->
    ((fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
       (fun ii -> Node (l, o, (add ii v r)))
       (fun ii -> Node ((add ii v l), o, r))
       (fun _ -> Node (l, (Some v), r))
       i)

  (** val remove : key -> 'a1 t -> 'a1 t **)

  let rec remove i m =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun ii ->
      match m with
      | Leaf -> Leaf
      | Node (l, o, r) ->
        (match l with
         | Leaf ->
           (match o with
            | Some _ -> Node (l, o, (remove ii r))
            | None ->
              (match remove ii r with
               | Leaf -> Leaf
               | Node (t0, o0, t1) -> Node (Leaf, None, (Node (t0, o0, t1)))))
         | Node (_, _, _) -> Node (l, o, (remove ii r))))
      (fun ii ->
      match m with
      | Leaf -> Leaf
      | Node (l, o, r) ->
        (match o with
         | Some _ -> Node ((remove ii l), o, r)
         | None ->
           (match r with
            | Leaf ->
              (match remove ii l with
               | Leaf -> Leaf
               | Node (t0, o0, t1) -> Node ((Node (t0, o0, t1)), None, Leaf))
            | Node (_, _, _) -> Node ((remove ii l), o, r))))
      (fun _ ->
      match m with
      | Leaf -> Leaf
      | Node (l, _, r) ->
        (match l with
         | Leaf ->
           (match r with
            | Leaf -> Leaf
            | Node (_, _, _) -> Node (l, None, r))
         | Node (_, _, _) -> Node (l, None, r)))
      i

  (** val xelements : 'a1 t -> key -> (key * 'a1) list **)

  let rec xelements m i =
    match m with
    | Leaf -> []
    | Node (l, o, r) ->
      (match o with
       | Some x ->
         app
           (xelements l
             (append i ((fun p -> Integer.shift_left p 1) Integer.one))) ((i,
           x) :: (xelements r
                   (append i
                     ((fun p -> Integer.succ (Integer.shift_left p 1))
                     Integer.one))))
       | None ->
         app
           (xelements l
             (append i ((fun p -> Integer.shift_left p 1) Integer.one)))
           (xelements r
             (append i ((fun p -> Integer.succ (Integer.shift_left p 1))
               Integer.one))))

  (** val elements : 'a1 t -> (key * 'a1) list **)

  let elements m =
    xelements m Integer.one

  (** val cardinal : 'a1 t -> int **)

  let rec cardinal = function
  | Leaf -> 0
  | Node (l, o, r) ->
    (match o with
     | Some _ -> succ (Coq__1.add (cardinal l) (cardinal r))
     | None -> Coq__1.add (cardinal l) (cardinal r))

  (** val xfind : key -> key -> 'a1 t -> 'a1 option **)

  let rec xfind i j m =
    (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
      (fun ii ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun jj -> xfind ii jj m)
        (fun _ -> None)
        (fun _ -> find i m)
        j)
      (fun ii ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> None)
        (fun jj -> xfind ii jj m)
        (fun _ -> find i m)
        j)
      (fun _ ->
      (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
        (fun _ -> None)
        (fun _ -> None)
        (fun _ -> find i m)
        j)
      i

  (** val xmapi : (key -> 'a1 -> 'a2) -> 'a1 t -> key -> 'a2 t **)

  let rec xmapi f m i =
    match m with
    | Leaf -> Leaf
    | Node (l, o, r) ->
      Node
        ((xmapi f l
           (append i ((fun p -> Integer.shift_left p 1) Integer.one))),
        (option_map (f i) o),
        (xmapi f r
          (append i ((fun p -> Integer.succ (Integer.shift_left p 1))
            Integer.one))))

  (** val mapi : (key -> 'a1 -> 'a2) -> 'a1 t -> 'a2 t **)

  let mapi f m =
    xmapi f m Integer.one

  (** val map : ('a1 -> 'a2) -> 'a1 t -> 'a2 t **)

  let map f m =
    mapi (fun _ -> f) m

  (** val xmap2_l :
      ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a3 t **)

  let rec xmap2_l f = function
  | Leaf -> Leaf
  | Node (l, o, r) -> Node ((xmap2_l f l), (f o None), (xmap2_l f r))

  (** val xmap2_r :
      ('a1 option -> 'a2 option -> 'a3 option) -> 'a2 t -> 'a3 t **)

  let rec xmap2_r f = function
  | Leaf -> Leaf
  | Node (l, o, r) -> Node ((xmap2_r f l), (f None o), (xmap2_r f r))

  (** val _map2 :
      ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a2 t -> 'a3 t **)

  let rec _map2 f m1 m2 =
    match m1 with
    | Leaf -> xmap2_r f m2
    | Node (l1, o1, r1) ->
      (match m2 with
       | Leaf -> xmap2_l f m1
       | Node (l2, o2, r2) ->
         Node ((_map2 f l1 l2), (f o1 o2), (_map2 f r1 r2)))

  (** val map2 :
      ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a2 t -> 'a3 t **)

  let map2 f =
    _map2 (fun o1 o2 ->
      match o1 with
      | Some _ -> f o1 o2
      | None -> (match o2 with
                 | Some _ -> f o1 o2
                 | None -> None))

  (** val xfoldi :
      (key -> 'a1 -> 'a2 -> 'a2) -> 'a1 t -> 'a2 -> key -> 'a2 **)

  let rec xfoldi f m v i =
    match m with
    | Leaf -> v
    | Node (l, o, r) ->
      (match o with
       | Some x ->
         xfoldi f r
           (f i x
             (xfoldi f l v
               (append i ((fun p -> Integer.shift_left p 1) Integer.one))))
           (append i ((fun p -> Integer.succ (Integer.shift_left p 1))
             Integer.one))
       | None ->
         xfoldi f r
           (xfoldi f l v
             (append i ((fun p -> Integer.shift_left p 1) Integer.one)))
           (append i ((fun p -> Integer.succ (Integer.shift_left p 1))
             Integer.one)))

  (** val fold : (key -> 'a1 -> 'a2 -> 'a2) -> 'a1 t -> 'a2 -> 'a2 **)

  let fold f m i =
    xfoldi f m i Integer.one

  (** val equal : ('a1 -> 'a1 -> bool) -> 'a1 t -> 'a1 t -> bool **)

  let rec equal cmp m1 m2 =
    match m1 with
    | Leaf -> is_empty m2
    | Node (l1, o1, r1) ->
      (match m2 with
       | Leaf -> is_empty m1
       | Node (l2, o2, r2) ->
         (&&)
           ((&&)
             (match o1 with
              | Some v1 ->
                (match o2 with
                 | Some v2 -> cmp v1 v2
                 | None -> false)
              | None -> (match o2 with
                         | Some _ -> false
                         | None -> true)) (equal cmp l1 l2)) (equal cmp r1 r2))
 end

module PM = PositiveMap

type zpolygon = { outlines : Integer.t list; holes : Integer.t list }

(** val key0 : Integer.t -> Integer.t **)

let key0 r =
  (fun zero positive negative z ->
     let s = Integer.sign z in if s = 0 then zero () else if s > 0 then positive z else negative (Integer.neg z))
    (fun _ -> Integer.one)
    (fun p -> (fun p -> Integer.shift_left p 1) p)
    (fun p -> (fun p -> Integer.succ (Integer.shift_left p 1)) p)
    r

type table = (Integer.t * bool) list PM.t

(** val roles : table -> Integer.t -> (Integer.t * bool) list **)

let roles m k =
  match PM.find k m with
  | Some l -> l
  | None -> []

(** val add_roles : Integer.t -> bool -> Integer.t list -> table -> table **)

let add_roles p hole l m =
  fold_left (fun m0 r ->
    PM.add (key0 r) ((p, hole) :: (roles m0 (key0 r))) m0) l m

(** val table_of : Integer.t -> zpolygon list -> table -> table **)

let rec table_of p ps m =
  match ps with
  | [] -> m
  | g :: r ->
    table_of (Pos.succ p) r
      (add_roles p true g.holes (add_roles p false g.outlines m))

type rings = unit PM.t

type around = { odd : rings; parts : (rings * rings) PM.t; covering : rings }

(** val outside : around **)

let outside =
  { odd = PM.empty; parts = PM.empty; covering = PM.empty }

(** val has : Integer.t -> rings -> bool **)

let has =
  PM.mem

(** val put : bool -> Integer.t -> rings -> rings **)

let put on k m =
  if on then PM.add k () m else PM.remove k m

(** val part : Integer.t -> around -> rings * rings **)

let part p w =
  match PM.find p w.parts with
  | Some g -> g
  | None -> (PM.empty, PM.empty)

(** val is_cover : (rings * rings) -> bool **)

let is_cover g =
  (&&) (negb (PM.is_empty (fst g))) (PM.is_empty (snd g))

(** val put_role :
    bool -> Integer.t -> around -> (Integer.t * bool) -> around **)

let put_role on k w = function
| (p, hole) ->
  let (o, h) = part p w in
  let g = if hole then (o, (put on k h)) else ((put on k o), h) in
  { odd = w.odd; parts = (PM.add p g w.parts); covering =
  (put (is_cover g) p w.covering) }

(** val flip : table -> around -> Integer.t -> around **)

let flip m w r =
  let k = key0 r in
  let on = negb (has k w.odd) in
  fold_left (put_role on k) (roles m k) { odd = (put on k w.odd); parts =
    w.parts; covering = w.covering }

(** val is_covered : around -> bool **)

let is_covered w =
  negb (PM.is_empty w.covering)

type zpoint = { zx : Integer.t; zy : Integer.t }

(** val zorient : zpoint -> zpoint -> zpoint -> Integer.t **)

let zorient a b c =
  Integer.sub (Integer.mul (Integer.sub b.zx a.zx) (Integer.sub c.zy a.zy))
    (Integer.mul (Integer.sub b.zy a.zy) (Integer.sub c.zx a.zx))

(** val zcircle : zpoint -> zpoint -> zpoint -> zpoint -> Integer.t **)

let zcircle a b c p =
  let ax = Integer.sub a.zx p.zx in
  let ay = Integer.sub a.zy p.zy in
  let bx = Integer.sub b.zx p.zx in
  let by_ = Integer.sub b.zy p.zy in
  let cx = Integer.sub c.zx p.zx in
  let cy = Integer.sub c.zy p.zy in
  Integer.add
    (Integer.add
      (Integer.mul (Integer.add (Integer.mul ax ax) (Integer.mul ay ay))
        (Integer.sub (Integer.mul bx cy) (Integer.mul by_ cx)))
      (Integer.mul (Integer.add (Integer.mul bx bx) (Integer.mul by_ by_))
        (Integer.sub (Integer.mul cx ay) (Integer.mul cy ax))))
    (Integer.mul (Integer.add (Integer.mul cx cx) (Integer.mul cy cy))
      (Integer.sub (Integer.mul ax by_) (Integer.mul ay bx)))

(** val compare_points : zpoint -> zpoint -> comparison **)

let compare_points a b =
  match (fun x y -> let c = Integer.compare x y in if c < 0 then Lt else if c = 0 then Eq else Gt)
          a.zx b.zx with
  | Eq ->
    (fun x y -> let c = Integer.compare x y in if c < 0 then Lt else if c = 0 then Eq else Gt)
      a.zy b.zy
  | x -> x

(** val before : zpoint -> zpoint -> bool **)

let before a b =
  match compare_points a b with
  | Lt -> true
  | _ -> false

(** val same : zpoint -> zpoint -> bool **)

let same a b =
  match compare_points a b with
  | Eq -> true
  | _ -> false

type zside = { left_end : zpoint; right_end : zpoint }

(** val compare_sides : zside -> zside -> comparison **)

let compare_sides s t0 =
  match compare_points s.left_end t0.left_end with
  | Eq -> compare_points s.right_end t0.right_end
  | x -> x

type zmarks = { mark_ab : bool; mark_bc : bool; mark_ca : bool }

type ztriangle = { corner_a : zpoint; corner_b : zpoint; corner_c : zpoint;
                   marks : zmarks; value : Integer.t;
                   rings_ab : Integer.t list; rings_bc : Integer.t list }

type zdomain =
| Hull
| EvenOdd
| NonZero
| Polygons of zpolygon list

type zedge = { edge_from : zpoint; edge_through : zpoint list;
               edge_to : zpoint; edge_ring : Integer.t option }

type record =
| NewPoint of zpoint
| NewEdge of zedge
| NewLower of zside
| NewTriangle of ztriangle
| Forget

type item = { item_side : zside; below : zpoint option; marked : bool;
              level : Integer.t; beneath : around }

type zrise = { rise_side : zside; rise_ring : Integer.t; rise : Integer.t }

(** val compare_rises : zrise -> zrise -> comparison **)

let compare_rises x y =
  match compare_sides x.rise_side y.rise_side with
  | Eq ->
    (fun x y -> let c = Integer.compare x y in if c < 0 then Lt else if c = 0 then Eq else Gt)
      x.rise_ring y.rise_ring
  | x0 -> x0

type state = { passed : item list; ahead : item list; brought : zpoint list;
               used : zside list; rises : zrise list }

(** val go_right :
    zpoint -> item list -> item list -> item list * item list **)

let rec go_right a passed0 ahead0 = match ahead0 with
| [] -> (passed0, [])
| i :: r ->
  if same a i.item_side.left_end
  then (passed0, ahead0)
  else go_right a (i :: passed0) r

(** val go_left :
    zpoint -> item list -> item list -> item list * item list **)

let rec go_left a passed0 ahead0 =
  match passed0 with
  | [] -> ([], ahead0)
  | i :: r ->
    if same a i.item_side.left_end
    then (r, (i :: ahead0))
    else go_left a r (i :: ahead0)

(** val go : zpoint -> item list -> item list -> item list * item list **)

let go a passed0 ahead0 = match ahead0 with
| [] -> go_left a passed0 ahead0
| i :: _ ->
  if before a i.item_side.left_end
  then go_left a passed0 ahead0
  else go_right a passed0 ahead0

(** val zfirst : zpoint -> zpoint -> bool **)

let zfirst a b =
  match (fun x y -> let c = Integer.compare x y in if c < 0 then Lt else if c = 0 then Eq else Gt)
          a.zx b.zx with
  | Eq -> Integer.leq b.zy a.zy
  | Lt -> true
  | Gt -> false

(** val tie_is_right : zpoint -> zpoint -> zpoint -> zpoint -> bool **)

let tie_is_right a b c d =
  let f = if zfirst a b then a else b in (&&) (zfirst f c) (zfirst f d)

(** val legal : bool -> bool -> zpoint -> item -> bool **)

let legal rule mark c i =
  match i.below with
  | Some d ->
    if mark
    then i.marked
    else if i.marked
         then false
         else let a = i.item_side.left_end in
              let b = i.item_side.right_end in
              (match (fun x y -> let c = Integer.compare x y in if c < 0 then Lt else if c = 0 then Eq else Gt)
                       (zcircle a b c d) Integer.zero with
               | Eq -> (||) (negb rule) (tie_is_right a b c d)
               | Lt -> true
               | Gt -> false)
  | None -> true

(** val use : bool -> item -> zside list -> zside list **)

let use mark i l =
  if mark then i.item_side :: l else l

(** val enter : table option -> Integer.t list -> item -> around **)

let enter judge rs i =
  match judge with
  | Some m -> fold_left (flip m) rs i.beneath
  | None -> i.beneath

(** val told : table option -> around -> Integer.t -> bool **)

let told judge w v =
  match judge with
  | Some _ -> eqb (is_covered w) (negb (Integer.equal v Integer.zero))
  | None -> true

(** val add_rise :
    table option -> Integer.t -> Integer.t list -> item -> zrise list ->
    zrise list **)

let add_rise judge v rs i l =
  match judge with
  | Some _ ->
    fold_left (fun l0 r -> { rise_side = i.item_side; rise_ring = r; rise =
      Integer.one } :: l0) rs l
  | None ->
    if Integer.equal v i.level
    then l
    else { rise_side = i.item_side; rise_ring = Integer.zero; rise =
           (Integer.sub v i.level) } :: l

(** val step : bool -> table option -> ztriangle -> state -> state option **)

let step rule judge t0 s =
  let a = t0.corner_a in
  let b = t0.corner_b in
  let c = t0.corner_c in
  let m = t0.marks in
  let v = t0.value in
  if Integer.lt Integer.zero (zorient a b c)
  then let (l, l0) = go a s.passed s.ahead in
       (match l0 with
        | [] -> None
        | i :: r ->
          let w = enter judge t0.rings_ab i in
          if (&&)
               ((&&)
                 ((&&) (same a i.item_side.left_end)
                   (same b i.item_side.right_end)) (legal rule m.mark_ab c i))
               (told judge w v)
          then if before c b
               then if before a c
                    then Some { passed = l; ahead = ({ item_side =
                           { left_end = a; right_end = c }; below = (Some b);
                           marked = m.mark_ca; level = v; beneath =
                           w } :: ({ item_side = { left_end = c; right_end =
                           b }; below = (Some a); marked = m.mark_bc; level =
                           v; beneath = w } :: r)); brought =
                           (c :: s.brought); used = (use m.mark_ab i s.used);
                           rises = (add_rise judge v t0.rings_ab i s.rises) }
                    else None
               else (match r with
                     | [] -> None
                     | j :: r' ->
                       if (&&)
                            ((&&) (same b j.item_side.left_end)
                              (same c j.item_side.right_end))
                            (legal rule m.mark_bc a j)
                       then Some { passed = l; ahead = ({ item_side =
                              { left_end = a; right_end = c }; below = (Some
                              b); marked = m.mark_ca; level = v; beneath =
                              w } :: r'); brought = s.brought; used =
                              (use m.mark_ab i (use m.mark_bc j s.used));
                              rises =
                              (add_rise judge v t0.rings_ab i
                                (add_rise judge v t0.rings_bc j s.rises)) }
                       else None)
          else None)
  else None

(** val chain : Integer.t -> zside -> zside list -> bool **)

let rec chain sign s l =
  (&&) (before s.left_end s.right_end)
    (match l with
     | [] -> true
     | t0 :: r ->
       (&&)
         ((&&) (same s.right_end t0.left_end)
           (Integer.leq Integer.zero
             (Integer.mul sign (zorient s.left_end s.right_end t0.right_end))))
         (chain sign t0 r))

(** val last_end : zside -> zside list -> zpoint **)

let rec last_end s = function
| [] -> s.right_end
| t0 :: r -> last_end t0 r

(** val first_item : zside -> item **)

let first_item s =
  { item_side = s; below = None; marked = false; level = Integer.zero;
    beneath = outside }

(** val joins : zside -> zside -> bool **)

let joins s t0 =
  (&&) (same s.right_end t0.left_end)
    (Integer.leq Integer.zero (zorient s.left_end s.right_end t0.right_end))

(** val lengthen :
    zside -> (zside * zside) option -> state -> ((zside * zside) * state)
    option **)

let lengthen x low0 s =
  if before x.left_end x.right_end
  then let i = first_item x in
       (match low0 with
        | Some p ->
          let (f, l) = p in
          if joins x f
          then Some ((x, l), { passed = []; ahead =
                 (i :: (rev_append s.passed s.ahead)); brought =
                 (x.left_end :: s.brought); used = s.used; rises = s.rises })
          else if joins l x
               then Some ((f, x), { passed = (rev_append s.ahead s.passed);
                      ahead = (i :: []); brought =
                      (x.right_end :: s.brought); used = s.used; rises =
                      s.rises })
               else None
        | None ->
          Some ((x, x), { passed = s.passed; ahead = (i :: s.ahead);
            brought = (x.left_end :: (x.right_end :: s.brought)); used =
            s.used; rises = s.rises }))
  else None

(** val piece : zpoint -> zpoint -> zside **)

let piece a b =
  if before a b
  then { left_end = a; right_end = b }
  else { left_end = b; right_end = a }

(** val inside : zpoint -> zpoint -> zpoint -> bool **)

let inside a v b =
  (&&) (Integer.equal (zorient a b v) Integer.zero)
    ((||) ((&&) (before a v) (before v b)) ((&&) (before b v) (before v a)))

(** val pieces_of :
    zpoint -> zpoint list -> zpoint -> zside list -> zside list option **)

let rec pieces_of a through b acc =
  match through with
  | [] -> Some ((piece a b) :: acc)
  | v :: r ->
    if inside a v b then pieces_of v r b ((piece a v) :: acc) else None

(** val pieces : zedge list -> zside list -> zside list option **)

let rec pieces es acc =
  match es with
  | [] -> Some acc
  | e :: r ->
    if same e.edge_from e.edge_to
    then pieces r acc
    else (match pieces_of e.edge_from e.edge_through e.edge_to acc with
          | Some acc' -> pieces r acc'
          | None -> None)

type line =
| NoPoint
| OnePlace of zpoint
| OnLine of zpoint * zpoint
| OffLine

(** val see : zpoint -> line -> line **)

let see p l = match l with
| NoPoint -> OnePlace p
| OnePlace a -> if same a p then l else OnLine (a, p)
| OnLine (a, b) ->
  if Integer.equal (zorient a b p) Integer.zero then l else OffLine
| OffLine -> OffLine

(** val map_items : (item -> 'a1) -> item list -> 'a1 list -> 'a1 list **)

let rec map_items f l acc =
  match l with
  | [] -> acc
  | i :: r -> map_items f r ((f i) :: acc)

(** val marked_sides : item list -> zside list -> zside list **)

let rec marked_sides l acc =
  match l with
  | [] -> acc
  | i :: r -> marked_sides r (use i.marked i acc)

(** val all_covered : item list -> bool **)

let rec all_covered = function
| [] -> true
| i :: r -> (match i.below with
             | Some _ -> all_covered r
             | None -> false)

(** val ring_of_key : Integer.t -> Integer.t **)

let ring_of_key k =
  (fun odd even one p -> if Integer.equal p Integer.one then one () else
     let half = Integer.shift_right p 1 in if Integer.is_odd p then odd half else even half)
    (fun p -> Integer.neg p)
    (fun p -> p)
    (fun _ -> Integer.zero)
    k

(** val last_rings : item -> Integer.t list **)

let last_rings i =
  PM.fold (fun k _ l -> (ring_of_key k) :: l) i.beneath.odd []

(** val last_rises : table option -> item list -> zrise list -> zrise list **)

let rec last_rises judge l acc =
  match l with
  | [] -> acc
  | i :: r ->
    last_rises judge r (add_rise judge Integer.zero (last_rings i) i acc)

(** val one_ring : zedge -> Integer.t option **)

let one_ring _ =
  Some Integer.zero

(** val fall : Integer.t -> zpoint -> zpoint -> zrise **)

let fall n a b =
  if before a b
  then { rise_side = { left_end = a; right_end = b }; rise_ring = n; rise =
         (Integer.neg Integer.one) }
  else { rise_side = { left_end = b; right_end = a }; rise_ring = n; rise =
         Integer.one }

(** val falls_of :
    Integer.t -> zpoint -> zpoint list -> zpoint -> zrise list -> zrise list **)

let rec falls_of n a through b acc =
  match through with
  | [] -> (fall n a b) :: acc
  | v :: r -> falls_of n v r b ((fall n a v) :: acc)

(** val falls :
    (zedge -> Integer.t option) -> zedge list -> zrise list -> zrise list **)

let rec falls ring_of es acc =
  match es with
  | [] -> acc
  | e :: r ->
    (match ring_of e with
     | Some n ->
       if same e.edge_from e.edge_to
       then falls ring_of r acc
       else falls ring_of r
              (falls_of n e.edge_from e.edge_through e.edge_to acc)
     | None -> falls ring_of r acc)

(** val balanced :
    (Integer.t -> bool) -> zrise -> Integer.t -> zrise list -> bool **)

let rec balanced fits x sum = function
| [] -> fits sum
| y :: r ->
  (match compare_rises x y with
   | Eq -> balanced fits x (Integer.add sum y.rise) r
   | _ -> (&&) (fits sum) (balanced fits y y.rise r))

(** val all_balanced : (Integer.t -> bool) -> zrise list -> bool **)

let all_balanced fits l =
  match sort compare_rises l with
  | [] -> true
  | x :: r -> balanced fits x x.rise r

(** val ends : zedge list -> zrise list -> zrise list **)

let rec ends es acc =
  match es with
  | [] -> acc
  | e :: r ->
    (match e.edge_ring with
     | Some n ->
       let at_point = fun p -> { rise_side = { left_end = p; right_end = p };
         rise_ring = n; rise = Integer.one }
       in
       ends r ((at_point e.edge_from) :: ((at_point e.edge_to) :: acc))
     | None -> ends r acc)

(** val falls_in : zdomain -> zedge list -> zrise list -> zrise list **)

let falls_in d es acc =
  match d with
  | Hull -> acc
  | Polygons _ -> falls (fun z0 -> z0.edge_ring) es acc
  | _ -> falls one_ring es acc

(** val ends_in : zdomain -> zedge list -> zrise list -> zrise list **)

let ends_in d es acc =
  match d with
  | Polygons _ -> ends es acc
  | _ -> acc

(** val values_right : zdomain -> zrise list -> zrise list -> bool **)

let values_right d rs open1 =
  match d with
  | Hull -> true
  | EvenOdd -> all_balanced Integer.is_even rs
  | NonZero -> all_balanced (Integer.equal Integer.zero) rs
  | Polygons _ ->
    (&&) (all_balanced Integer.is_even rs)
      (all_balanced Integer.is_even open1)

(** val judge_of : zdomain -> table option **)

let judge_of = function
| Polygons ps -> Some (table_of Integer.one ps PM.empty)
| _ -> None

type course = { laying : state; low : (zside * zside) option;
                given : zpoint list; split : zside list; fallen : zrise list;
                open0 : zrise list; seen_line : line; is_empty0 : bool }

(** val start : course **)

let start =
  { laying = { passed = []; ahead = []; brought = []; used = []; rises =
    [] }; low = None; given = []; split = []; fallen = []; open0 = [];
    seen_line = NoPoint; is_empty0 = true }

(** val take :
    bool -> zdomain -> table option -> record -> course -> course option **)

let take rule d judge r c =
  let s = c.laying in
  (match r with
   | NewPoint p ->
     Some { laying = s; low = c.low; given = (p :: c.given); split = c.split;
       fallen = c.fallen; open0 = c.open0; seen_line = (see p c.seen_line);
       is_empty0 = c.is_empty0 }
   | NewEdge e ->
     (match pieces (e :: []) c.split with
      | Some ps ->
        Some { laying = s; low = c.low; given = c.given; split = ps; fallen =
          (falls_in d (e :: []) c.fallen); open0 =
          (ends_in d (e :: []) c.open0); seen_line = c.seen_line; is_empty0 =
          c.is_empty0 }
      | None -> None)
   | NewLower x ->
     (match lengthen x c.low s with
      | Some p ->
        let (p0, s') = p in
        Some { laying = s'; low = (Some p0); given = c.given; split =
        c.split; fallen = c.fallen; open0 = c.open0; seen_line = c.seen_line;
        is_empty0 = c.is_empty0 }
      | None -> None)
   | NewTriangle t0 ->
     (match step rule judge t0 s with
      | Some s' ->
        Some { laying = s'; low = c.low; given = c.given; split = c.split;
          fallen = c.fallen; open0 = c.open0; seen_line = c.seen_line;
          is_empty0 = false }
      | None -> None)
   | Forget ->
     (match judge with
      | Some _ -> Some c
      | None ->
        let (g, b) = cancel compare_points c.given s.brought in
        let (p, u) = cancel compare_sides c.split s.used in
        Some { laying = { passed = s.passed; ahead = s.ahead; brought = b;
        used = u; rises = s.rises }; low = c.low; given = g; split = p;
        fallen = c.fallen; open0 = c.open0; seen_line = c.seen_line;
        is_empty0 = c.is_empty0 }))

(** val finish : zdomain -> table option -> course -> bool **)

let finish d judge c =
  if c.is_empty0
  then (match c.seen_line with
        | OffLine -> false
        | _ -> true)
  else let s = c.laying in
       let front = rev_append s.passed s.ahead in
       (match c.low with
        | Some p ->
          let (f, l) = p in
          (match rev_append (map_items (fun i -> i.item_side) front []) [] with
           | [] -> false
           | t0 :: h ->
             (&&)
               ((&&)
                 ((&&)
                   ((&&)
                     ((&&)
                       ((&&) (all_covered front)
                         (chain (Integer.neg Integer.one) t0 h))
                       (same f.left_end t0.left_end))
                     (same l.right_end (last_end t0 h)))
                   (same_set_once compare_points c.given s.brought))
                 (same_set compare_sides c.split (marked_sides front s.used)))
               (values_right d
                 (rev_append c.fallen (last_rises judge front s.rises))
                 c.open0))
        | None -> false)
