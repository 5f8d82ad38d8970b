(* What the checker sees of triangles that it accepts: a list of facts about real points. All else follows from them. *)
Require Import Reals ZArith List Lra Lia Bool Permutation.
Require Import Spec Geometry Count Sort Rings Check Place Border Laid Pieces Course.
Import ListNotations.
Open Scope R_scope.

Definition on_edge (E : list edge) (a b : point) : Prop :=
  exists p q, In (p, q) E /\ on_segment a p q /\ on_segment b p q.

Definition value_at (g : R * R * R) (q : point) : R := let '(k, m, w) := g in affine k m w q.

Record tiled (rule : bool) (P : list point) (E : list edge) (T : list triangle) : Prop := {
  t_positive : forall t, In t T -> positive t;
  t_some : exists t, In t T;
  t_corners : forall t p, In t T -> corner p t -> In p P;
  t_all : forall p, In p P -> exists t, In t T /\ corner p t;
  t_once : forall q, (total (count q) T <= 1)%Z;
  t_frame : exists G, (forall g, In g G -> (forall p, In p P -> 0 <= value_at g p) /\ exists z, value_at g z <> 0) /\
    forall q, (forall g, In g G -> 0 < value_at g q) -> (0 < total (count q) T)%Z;
  t_sides : forall t a b c, In t T -> turned t a b c ->
    (forall p, In p P -> 0 <= orient a b p) \/
    exists t' d, In t' T /\ turned t' b a d /\
      (on_edge E a b \/ (circle a b c d <= 0 /\ (rule = true -> circle a b c d = 0 -> tie_kept a b c d)));
  t_edges : forall a b q, In (a, b) E -> a <> b -> on_segment q a b ->
    exists t c d, In t T /\ side c d t /\ on_segment q c d /\ on_segment c a b /\ on_segment d a b
}.

(* Lists of sides. *)
Lemma marked_sides_in : forall l acc x, In x (marked_sides l acc) ->
  In x acc \/ exists i, In i l /\ marked i = true /\ x = item_side i.
Proof.
  induction l as [|i l IH]; cbn; intros acc x H; [auto|].
  destruct (IH _ _ H) as [I|(j & J & K)].
  - unfold use in I. destruct (marked i) eqn:M; [destruct I as [<-|I]|]; eauto 6.
  - right. exists j. auto.
Qed.

Lemma marked_sides_incl : forall l acc, incl acc (marked_sides l acc).
Proof.
  induction l as [|i l IH]; cbn; intros acc; [apply incl_refl|].
  apply incl_tran with (use (marked i) i acc); [apply use_incl|apply IH].
Qed.

Lemma all_covered_in : forall l, all_covered l = true -> forall i, In i l -> exists d, below i = Some d.
Proof.
  induction l as [|i l IH]; cbn; intros H j J; [easy|].
  destruct (below i) eqn:B; [|discriminate]. destruct J as [<-|J]; eauto.
Qed.

Section Tiling.
Variable u : R.
Hypothesis u_positive : 0 < u.

Notation tri := (place_triangle u).
Notation left_of s := (place u (left_end s)).
Notation right_of s := (place u (right_end s)).

Definition edge_function (s : R) (a b : point) : R * R * R :=
  (s * (Y a - Y b), s * (X b - X a), s * ((Y b - Y a) * X a - (X b - X a) * Y a)).

Lemma edge_value s a b q : value_at (edge_function s a b) q = s * orient a b q.
Proof. unfold value_at, edge_function, affine, orient. ring. Qed.

Lemma edge_nonzero s a b : s = 1 \/ s = -1 -> lex a b -> exists z, value_at (edge_function s a b) z <> 0.
Proof.
  intros S L. exists (Point (X a - (Y b - Y a)) (Y a + (X b - X a))). rewrite edge_value.
  unfold orient; cbn [X Y].
  assert (0 < (X b - X a) * (X b - X a) + (Y b - Y a) * (Y b - Y a)).
  { pose proof (Rle_0_sqr (X b - X a)). pose proof (Rle_0_sqr (Y b - Y a)). unfold Rsqr in *.
    destruct L as [L|[_ L]]; [assert (0 < (X b - X a) * (X b - X a))
      by nra | assert (0 < (Y b - Y a) * (Y b - Y a)) by nra];
    lra. }
  destruct S as [-> | ->]; lra.
Qed.

Theorem check_tiled rule k : check rule k = true -> triangles k <> [] ->
  tiled rule (map (place u) (points k)) (map (place_edge u) (edges k)) (map tri (triangles k)).
Proof.
  intros H N. destruct (check_inv rule k H N) as (low & sl & l & th & h & s & ps & ends & C).
  destruct C as [GR EL CL EH CH E1 E2 AC PS PB KM _ _].
  destruct (grown_laid u u_positive rule _ _ _ _ _ GR) as (done & LD & PD).
  set (fr := rev_append (passed s) (ahead s)) in *.
  assert (FR : forall i, In i fr <-> In i (front s)).
  { intros i. unfold fr, front. rewrite rev_append_rev, !in_app_iff, <- in_rev. tauto. }
  pose proof (chain_lex u u_positive _ _ _ CL) as LexL. rewrite <- EL in LexL.
  assert (TD : forall t, In t (triangles k) <-> In t done).
  { intros t. split; apply Permutation_in; [symmetry|]; assumption. }
  assert (TM : forall t, In t (map tri (triangles k)) <-> exists z, In z done /\ t = tri z).
  { intros t. rewrite in_map_iff. split; intros (z & A & Z); exists z.
    - split; [apply TD|]; auto.
    - split; [|apply TD]; auto. }
  assert (IT : forall z, In z done -> In (tri z) (map tri (triangles k))) by (intros z Z; apply TM; exists z; auto).
  assert (PM : forall p, In p (map (place u) (points k)) <-> exists z, In z (brought s) /\ p = place u z).
  { intros p. rewrite in_map_iff. split; intros (z & A & Z); exists z.
    - split; [apply PB|]; auto.
    - split; [|apply PB]; auto. }
  destruct (pieces_spec u u_positive _ _ _ PS) as (_ & PO & PC).
  assert (HI : forall x, In x (th :: h) <-> exists i, In i (front s) /\ item_side i = x).
  { intros x. rewrite <- EH, in_map_iff. split; intros (i & I & J); exists i.
    - split; [apply FR|]; auto.
    - split; [|apply FR]; auto. }
  assert (COUNT : forall q, (total (count q) (map tri (triangles k))
      + total (fun x => above (left_of x) (right_of x) q) (th :: h)
      = total (fun x => above (left_of x) (right_of x) q) (sl :: l))%Z).
  { intros q. rewrite <- EL, <- (l_count _ _ _ _ _ LD q), <- EH. f_equal.
    - rewrite <- (total_permutation _ _ _ (Permutation_sym PD)). clear.
      induction (triangles k) as [|t r IH]; [reflexivity|]. cbn [map]. rewrite !total_cons, IH. reflexivity.
    - assert (PF : Permutation (front s) fr).
      { unfold fr, front. rewrite rev_append_rev. apply Permutation_app_tail, Permutation_rev. }
      rewrite (total_permutation _ _ _ PF). clear.
      induction fr as [|t r IH]; [reflexivity|]. cbn [map]. rewrite !total_cons, IH. reflexivity. }
  (* what bounds the hull *)
  assert (LP : forall x, In x (sl :: l) -> forall p, In p (map (place u) (points k)) ->
    0 <= orient (left_of x) (right_of x) p).
  { intros x Hx p Hp. apply PM in Hp. destruct Hp as (z & Z & ->).
    rewrite orient_affine.
    assert (LX : lex (left_of x) (right_of x)) by (apply LexL; rewrite EL; assumption).
    apply (l_up _ _ _ _ _ LD); try assumption.
    - unfold lex in LX; lra.
    - intros p Hp. rewrite <- orient_affine.
      apply ends_of_in in Hp. destruct Hp as (y & Hy & D). rewrite EL in Hy.
      destruct (chain_supports u u_positive 1 (or_introl eq_refl) _ _ CL x y Hx Hy) as [A C].
      destruct D as [-> | ->]; lra. }
  pose proof (chain_lex u u_positive _ _ _ CH) as LexH.
  assert (HP : forall x, In x (th :: h) -> forall p, In p (map (place u) (points k)) ->
    0 <= - orient (left_of x) (right_of x) p).
  { intros x Hx p Hp. apply PM in Hp. destruct Hp as (z & Z & ->).
    assert (LX : lex (left_of x) (right_of x)) by (apply LexH; assumption).
    replace (- orient (left_of x) (right_of x) (place u z)) with (-1 * orient (left_of x) (right_of x) (place u z))
      by ring.
    rewrite <- edge_value. unfold value_at, edge_function.
    apply (l_down _ _ _ _ _ LD); try assumption.
    - unfold lex in LX; lra.
    - intros i Hi.
      pose proof (edge_value (-1) (left_of x) (right_of x)) as EV. unfold value_at, edge_function in EV. rewrite !EV.
      assert (Hy : In (item_side i) (th :: h)) by (apply HI; exists i; auto).
      exact (chain_supports u u_positive (-1) (or_intror eq_refl) _ _ CH x _ Hx Hy). }
  set (x0 := X (left_of sl)). set (x1 := X (place u (last_end sl l))).
  assert (XP : forall p, In p (map (place u) (points k)) -> x0 <= X p <= x1).
  { intros p Hp. apply PM in Hp. destruct Hp as (z & Z & ->). split.
    - assert (0 <= affine 1 0 (- x0) (place u z)); [|unfold affine in *; lra].
      apply (l_up _ _ _ _ _ LD); try assumption; [lra|].
      intros p Hp. apply ends_of_in in Hp. destruct Hp as (y & Hy & D). rewrite EL in Hy. pose proof (chain_range u u_positive _ _ _ CL y Hy) as R. fold x0 in R.
      unfold affine. destruct D as [-> | ->]; lra.
    - assert (0 <= affine (-1) 0 x1 (place u z)); [|unfold affine in *; lra].
      apply (l_up _ _ _ _ _ LD); try assumption; [lra|].
      intros p Hp. apply ends_of_in in Hp. destruct Hp as (y & Hy & D). rewrite EL in Hy. pose proof (chain_range u u_positive _ _ _ CL y Hy) as R. fold x1 in R.
      unfold affine. destruct D as [-> | ->]; lra. }
  assert (KU : forall x, In x (marked_sides fr (used s)) -> exists z a b, In z done /\ side a b (tri z) /\
       ((a = left_of x /\ b = right_of x) \/ (a = right_of x /\ b = left_of x))).
  { intros x Hx. destruct (marked_sides_in _ _ _ Hx) as [I|(i & I & M & ->)].
    - destruct (l_used _ _ _ _ _ LD x I) as (t & c & Z & T).
      exists t, (left_of x), (right_of x). split; [assumption|]. split; [apply side_turned; exists c; assumption|auto].
    - pose proof (all_covered_in _ AC i I) as [d BD]. apply FR in I.
      pose proof (l_below _ _ _ _ _ LD i I) as T. rewrite BD in T. destruct T as (t & Z & T).
      do 3 eexists. split; [exact Z|]. split; [apply side_turned; eexists; exact T|]. right; auto. }
  assert (KE : forall x, In x (used s) -> exists a b, In (a, b) (map (place_edge u) (edges k)) /\
     on_segment (left_of x) a b /\ on_segment (right_of x) a b).
  { intros x Hx. apply (marked_sides_incl fr) in Hx. apply KM in Hx. destruct (PO x Hx) as [[]|]; assumption. }
  split.
  - intros t Ht. apply TM in Ht. destruct Ht as (z & Z & ->). apply (l_positive _ _ _ _ _ LD). assumption.
  - destruct (triangles k) as [|t0 ts]; [congruence|]. exists (tri t0). left; reflexivity.
  - intros t p Ht C. apply TM in Ht. destruct Ht as (z & Z & ->). apply PM.
    destruct (l_corners _ _ _ _ _ LD z Z) as (A & B & D). destruct C as [->|[->| ->]];
      [exists (corner_a z) | exists (corner_b z) | exists (corner_c z)]; auto.
  - intros p Hp. apply PM in Hp. destruct Hp as (z & Z & ->).
    destruct (l_brought _ _ _ _ _ LD z Z) as [I|(t & I & C)]; [|exists (tri t); auto].
    apply ends_of_in in I. destruct I as (y & Hy & D).
    destruct (l_low _ _ _ _ _ LD y Hy) as [(i & J & _ & B)|(t & c & J & T)].
    + apply FR in J. destruct (all_covered_in _ AC i J) as [d BD]. congruence.
    + exists (tri t). split; [auto|]. apply (turned_corner _ _ _ _ _ T). destruct D as [-> | ->]; auto.
  - intros q. pose proof (COUNT q). pose proof (chain_above_one u u_positive _ q _ _ CL).
    pose proof (chain_above_one u u_positive _ q _ _ CH). lia.
  - exists ((1, 0, - x0) :: (-1, 0, x1) :: map (fun x => edge_function 1 (left_of x) (right_of x)) (sl :: l)
        ++ map (fun x => edge_function (-1) (left_of x) (right_of x)) (th :: h)).
    split.
    + intros g [<-|[<-|G]].
      * split; [|exists (Point (x0 + 1) 0); unfold value_at, affine; cbn [X Y]; lra].
        intros p Hp. pose proof (XP p Hp). unfold value_at, affine. lra.
      * split; [|exists (Point (x1 + 1) 0); unfold value_at, affine; cbn [X Y]; lra].
        intros p Hp. pose proof (XP p Hp). unfold value_at, affine. lra.
      * apply in_app_or in G. destruct G as [G|G]; apply in_map_iff in G; destruct G as (x & <- & I).
        -- split; [|apply edge_nonzero; auto; apply LexL; rewrite EL; assumption].
           intros p Hp. rewrite edge_value. pose proof (LP x I p Hp). lra.
        -- split; [|apply edge_nonzero; auto; apply LexH; assumption].
           intros p Hp. rewrite edge_value. pose proof (HP x I p Hp). lra.
    + intros q G. pose proof (COUNT q) as C.
      rewrite (chain_above_all u u_positive 1 q l sl CL) in C.
      * rewrite chain_above_none in C; [lia|]. intros x I.
        assert (V : 0 < value_at (edge_function (-1) (left_of x) (right_of x)) q).
        { apply G. right; right. apply in_or_app. right. apply in_map_iff. exists x. auto. }
        rewrite edge_value in V. lra.
      * intros x I. assert (V : 0 < value_at (edge_function 1 (left_of x) (right_of x)) q).
        { apply G. right; right. apply in_or_app. left. apply in_map_iff. exists x. auto. }
        rewrite edge_value in V. lra.
      * pose proof (G _ (or_introl eq_refl)) as G0. pose proof (G _ (or_intror (or_introl eq_refl))) as G1.
        unfold value_at, affine in G0, G1. fold x0 x1. lra.
  - intros t a b c Ht T. apply TM in Ht. destruct Ht as (z & Z & ->).
    destruct (l_sides _ _ _ _ _ LD z a b c Z T) as [(i & d & I & B & -> & -> & ->)|[(x & I & ->
      & ->)|(t' & d & I & T' & F)]].
    + left. intros p Hp. apply HI in I || idtac. assert (J : In (item_side i) (th :: h)) by (apply HI; exists i; auto).
      pose proof (HP _ J p Hp). rewrite orient_swap. lra.
    + left. intros p Hp. apply LP; [rewrite <- EL|]; assumption.
    + right. exists (tri t'), d. split; [auto|]. split; [assumption|].
      destruct F as [(x & I' & D)|F]; [left|right; assumption].
      destruct (KE x I') as (p & q & Hpq & S1 & S2). exists p, q.
      destruct D as [(<- & <-)|(<- & <-)]; auto.
  - intros a b q Hab Nab S. destruct (PC a b q Hab Nab S) as (x & I & Q & S1 & S2). apply KM in I.
    destruct (KU x I) as (z & c & d & Z & SD & [(-> & ->)|(-> & ->)]).
    + exists (tri z), (left_of x), (right_of x). auto 10.
    + exists (tri z), (right_of x), (left_of x). apply on_segment_swap in Q. auto 10.
Qed.
End Tiling.
