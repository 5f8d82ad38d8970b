
val negb : bool -> bool

val option_map : ('a1 -> 'a2) -> 'a1 option -> 'a2 option

val app : 'a1 list -> 'a1 list -> 'a1 list

type comparison =
| Eq
| Lt
| Gt

val add : int -> int -> int

val eqb : bool -> bool -> bool

module type EqLtLe =
 sig
  type t
 end

module MakeOrderTac :
 functor (O:EqLtLe) ->
 functor (P:sig
 end) ->
 sig
 end

module Pos :
 sig
  val succ : Integer.t -> Integer.t

  val add : Integer.t -> Integer.t -> Integer.t

  val add_carry : Integer.t -> Integer.t -> Integer.t

  val pred_double : Integer.t -> Integer.t

  val mul : Integer.t -> Integer.t -> Integer.t

  val compare_cont : comparison -> Integer.t -> Integer.t -> comparison

  val compare : Integer.t -> Integer.t -> comparison

  val eqb : Integer.t -> Integer.t -> bool
 end

module Z :
 sig
  val double : Integer.t -> Integer.t

  val succ_double : Integer.t -> Integer.t

  val pred_double : Integer.t -> Integer.t

  val pos_sub : Integer.t -> Integer.t -> Integer.t

  val opp : Integer.t -> Integer.t
 end

val rev_append : 'a1 list -> 'a1 list -> 'a1 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val goes_first : ('a1 -> 'a1 -> comparison) -> bool -> 'a1 -> 'a1 -> bool

val merge :
  ('a1 -> 'a1 -> comparison) -> bool -> 'a1 list -> 'a1 list -> 'a1 list ->
  'a1 list

val merge_pairs :
  ('a1 -> 'a1 -> comparison) -> bool -> 'a1 list list -> 'a1 list list -> 'a1
  list list

val merge_all :
  ('a1 -> 'a1 -> comparison) -> int -> bool -> 'a1 list list -> 'a1 list

val singles : 'a1 list -> 'a1 list list -> 'a1 list list

val sort : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list

val distinct : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> 'a1 list

val equal : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> bool

val same_set : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> bool

val ascending : ('a1 -> 'a1 -> comparison) -> 'a1 -> 'a1 list -> bool

val all_ascending : ('a1 -> 'a1 -> comparison) -> 'a1 list -> bool

val same_set_once : ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> bool

val apart :
  ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> 'a1 list -> 'a1 list
  -> 'a1 list * 'a1 list

val cancel :
  ('a1 -> 'a1 -> comparison) -> 'a1 list -> 'a1 list -> 'a1 list * 'a1 list

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

module OrderedTypeFacts :
 functor (O:OrderedType) ->
 sig
  module TO :
   sig
    type t = O.t
   end

  module IsTO :
   sig
   end

  module OrderTac :
   sig
   end

  val eq_dec : O.t -> O.t -> bool

  val lt_dec : O.t -> O.t -> bool

  val eqb : O.t -> O.t -> bool
 end

module KeyOrderedType :
 functor (O:OrderedType) ->
 sig
  module MO :
   sig
    module TO :
     sig
      type t = O.t
     end

    module IsTO :
     sig
     end

    module OrderTac :
     sig
     end

    val eq_dec : O.t -> O.t -> bool

    val lt_dec : O.t -> O.t -> bool

    val eqb : O.t -> O.t -> bool
   end
 end

module PositiveOrderedTypeBits :
 sig
  type t = Integer.t

  val compare : t -> t -> Integer.t compare0

  val eq_dec : Integer.t -> Integer.t -> bool
 end

val append : Integer.t -> Integer.t -> Integer.t

module PositiveMap :
 sig
  module E :
   sig
    type t = Integer.t

    val compare : t -> t -> Integer.t compare0

    val eq_dec : Integer.t -> Integer.t -> bool
   end

  module ME :
   sig
    module MO :
     sig
      module TO :
       sig
        type t = Integer.t
       end

      module IsTO :
       sig
       end

      module OrderTac :
       sig
       end

      val eq_dec : Integer.t -> Integer.t -> bool

      val lt_dec : Integer.t -> Integer.t -> bool

      val eqb : Integer.t -> Integer.t -> bool
     end
   end

  type key = Integer.t

  type 'a tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  val empty : 'a1 t

  val is_empty : 'a1 t -> bool

  val find : key -> 'a1 t -> 'a1 option

  val mem : key -> 'a1 t -> bool

  val add : key -> 'a1 -> 'a1 t -> 'a1 t

  val remove : key -> 'a1 t -> 'a1 t

  val xelements : 'a1 t -> key -> (key * 'a1) list

  val elements : 'a1 t -> (key * 'a1) list

  val cardinal : 'a1 t -> int

  val xfind : key -> key -> 'a1 t -> 'a1 option

  val xmapi : (key -> 'a1 -> 'a2) -> 'a1 t -> key -> 'a2 t

  val mapi : (key -> 'a1 -> 'a2) -> 'a1 t -> 'a2 t

  val map : ('a1 -> 'a2) -> 'a1 t -> 'a2 t

  val xmap2_l : ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a3 t

  val xmap2_r : ('a1 option -> 'a2 option -> 'a3 option) -> 'a2 t -> 'a3 t

  val _map2 :
    ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a2 t -> 'a3 t

  val map2 :
    ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a2 t -> 'a3 t

  val xfoldi : (key -> 'a1 -> 'a2 -> 'a2) -> 'a1 t -> 'a2 -> key -> 'a2

  val fold : (key -> 'a1 -> 'a2 -> 'a2) -> 'a1 t -> 'a2 -> 'a2

  val equal : ('a1 -> 'a1 -> bool) -> 'a1 t -> 'a1 t -> bool
 end

module PM :
 sig
  module E :
   sig
    type t = Integer.t

    val compare : t -> t -> Integer.t compare0

    val eq_dec : Integer.t -> Integer.t -> bool
   end

  module ME :
   sig
    module MO :
     sig
      module TO :
       sig
        type t = Integer.t
       end

      module IsTO :
       sig
       end

      module OrderTac :
       sig
       end

      val eq_dec : Integer.t -> Integer.t -> bool

      val lt_dec : Integer.t -> Integer.t -> bool

      val eqb : Integer.t -> Integer.t -> bool
     end
   end

  type key = Integer.t

  type 'a tree = 'a PositiveMap.tree =
  | Leaf
  | Node of 'a tree * 'a option * 'a tree

  type 'a t = 'a tree

  val empty : 'a1 t

  val is_empty : 'a1 t -> bool

  val find : key -> 'a1 t -> 'a1 option

  val mem : key -> 'a1 t -> bool

  val add : key -> 'a1 -> 'a1 t -> 'a1 t

  val remove : key -> 'a1 t -> 'a1 t

  val xelements : 'a1 t -> key -> (key * 'a1) list

  val elements : 'a1 t -> (key * 'a1) list

  val cardinal : 'a1 t -> int

  val xfind : key -> key -> 'a1 t -> 'a1 option

  val xmapi : (key -> 'a1 -> 'a2) -> 'a1 t -> key -> 'a2 t

  val mapi : (key -> 'a1 -> 'a2) -> 'a1 t -> 'a2 t

  val map : ('a1 -> 'a2) -> 'a1 t -> 'a2 t

  val xmap2_l : ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a3 t

  val xmap2_r : ('a1 option -> 'a2 option -> 'a3 option) -> 'a2 t -> 'a3 t

  val _map2 :
    ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a2 t -> 'a3 t

  val map2 :
    ('a1 option -> 'a2 option -> 'a3 option) -> 'a1 t -> 'a2 t -> 'a3 t

  val xfoldi : (key -> 'a1 -> 'a2 -> 'a2) -> 'a1 t -> 'a2 -> key -> 'a2

  val fold : (key -> 'a1 -> 'a2 -> 'a2) -> 'a1 t -> 'a2 -> 'a2

  val equal : ('a1 -> 'a1 -> bool) -> 'a1 t -> 'a1 t -> bool
 end

type zpolygon = { outlines : Integer.t list; holes : Integer.t list }

val key0 : Integer.t -> Integer.t

type table = (Integer.t * bool) list PM.t

val roles : table -> Integer.t -> (Integer.t * bool) list

val add_roles : Integer.t -> bool -> Integer.t list -> table -> table

val table_of : Integer.t -> zpolygon list -> table -> table

type rings = unit PM.t

type around = { odd : rings; parts : (rings * rings) PM.t; covering : rings }

val outside : around

val has : Integer.t -> rings -> bool

val put : bool -> Integer.t -> rings -> rings

val part : Integer.t -> around -> rings * rings

val is_cover : (rings * rings) -> bool

val put_role : bool -> Integer.t -> around -> (Integer.t * bool) -> around

val flip : table -> around -> Integer.t -> around

val is_covered : around -> bool

type zpoint = { zx : Integer.t; zy : Integer.t }

val zorient : zpoint -> zpoint -> zpoint -> Integer.t

val zcircle : zpoint -> zpoint -> zpoint -> zpoint -> Integer.t

val compare_points : zpoint -> zpoint -> comparison

val before : zpoint -> zpoint -> bool

val same : zpoint -> zpoint -> bool

type zside = { left_end : zpoint; right_end : zpoint }

val compare_sides : zside -> zside -> comparison

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

val compare_rises : zrise -> zrise -> comparison

type state = { passed : item list; ahead : item list; brought : zpoint list;
               used : zside list; rises : zrise list }

val go_right : zpoint -> item list -> item list -> item list * item list

val go_left : zpoint -> item list -> item list -> item list * item list

val go : zpoint -> item list -> item list -> item list * item list

val zfirst : zpoint -> zpoint -> bool

val tie_is_right : zpoint -> zpoint -> zpoint -> zpoint -> bool

val legal : bool -> bool -> zpoint -> item -> bool

val use : bool -> item -> zside list -> zside list

val enter : table option -> Integer.t list -> item -> around

val told : table option -> around -> Integer.t -> bool

val add_rise :
  table option -> Integer.t -> Integer.t list -> item -> zrise list -> zrise
  list

val step : bool -> table option -> ztriangle -> state -> state option

val chain : Integer.t -> zside -> zside list -> bool

val last_end : zside -> zside list -> zpoint

val first_item : zside -> item

val joins : zside -> zside -> bool

val lengthen :
  zside -> (zside * zside) option -> state -> ((zside * zside) * state) option

val piece : zpoint -> zpoint -> zside

val inside : zpoint -> zpoint -> zpoint -> bool

val pieces_of :
  zpoint -> zpoint list -> zpoint -> zside list -> zside list option

val pieces : zedge list -> zside list -> zside list option

type line =
| NoPoint
| OnePlace of zpoint
| OnLine of zpoint * zpoint
| OffLine

val see : zpoint -> line -> line

val map_items : (item -> 'a1) -> item list -> 'a1 list -> 'a1 list

val marked_sides : item list -> zside list -> zside list

val all_covered : item list -> bool

val ring_of_key : Integer.t -> Integer.t

val last_rings : item -> Integer.t list

val last_rises : table option -> item list -> zrise list -> zrise list

val one_ring : zedge -> Integer.t option

val fall : Integer.t -> zpoint -> zpoint -> zrise

val falls_of :
  Integer.t -> zpoint -> zpoint list -> zpoint -> zrise list -> zrise list

val falls :
  (zedge -> Integer.t option) -> zedge list -> zrise list -> zrise list

val balanced : (Integer.t -> bool) -> zrise -> Integer.t -> zrise list -> bool

val all_balanced : (Integer.t -> bool) -> zrise list -> bool

val ends : zedge list -> zrise list -> zrise list

val falls_in : zdomain -> zedge list -> zrise list -> zrise list

val ends_in : zdomain -> zedge list -> zrise list -> zrise list

val values_right : zdomain -> zrise list -> zrise list -> bool

val judge_of : zdomain -> table option

type course = { laying : state; low : (zside * zside) option;
                given : zpoint list; split : zside list; fallen : zrise list;
                open0 : zrise list; seen_line : line; is_empty0 : bool }

val start : course

val take :
  bool -> zdomain -> table option -> record -> course -> course option

val finish : zdomain -> table option -> course -> bool
