(* What holds while triangles are laid on the front, one after the other. *)
Require Import Reals ZArith List Lra Lia Bool Permutation.
Require Import Spec Geometry Rings Check Place Count.
Import ListNotations.
Open Scope R_scope.

Lemma go_right_permutes a : forall h p l r, go_right a p h = (l, r) -> Permutation (p ++ h) (l ++ r).
Proof.
  induction h as [|i h IH]; cbn; intros p l r H.
  - injection H as <- <-. reflexivity.
  - destruct (same a (left_end (item_side i))).
    + injection H as <- <-. reflexivity.
    + apply IH in H. rewrite <- H. cbn. symmetry. apply Permutation_middle.
Qed.

Lemma go_left_permutes a : forall p h l r, go_left a p h = (l, r) -> Permutation (p ++ h) (l ++ r).
Proof.
  induction p as [|i p IH]; cbn; intros h l r H.
  - injection H as <- <-. reflexivity.
  - destruct (same a (left_end (item_side i))).
    + injection H as <- <-. apply Permutation_middle.
    + apply IH in H. rewrite <- H. apply Permutation_middle.
Qed.

Lemma go_permutes a p h l r : go a p h = (l, r) -> Permutation (p ++ h) (l ++ r).
Proof.
  unfold go. destruct h; [apply go_left_permutes|].
  destruct (before _ _); [apply go_left_permutes | apply go_right_permutes].
Qed.

Definition front (s : state) : list item := passed s ++ ahead s.

(* The two ways in which a triangle is laid. *)
Lemma step_cases rule judge t s s' : step rule judge t s = Some s' ->
  let a := corner_a t in let b := corner_b t in let c := corner_c t in
  let m := marks t in let v := value t in
  (0 < zorient a b c)%Z /\ exists i, item_side i = ZSide a b /\ legal rule (mark_ab m) c i = true /\
  let w := enter judge (rings_ab t) i in told judge w v = true /\
  ((exists r, Permutation (front s) (i :: r) /\ before a c = true /\ before c b = true /\
      Permutation (front s')
        (Item (ZSide a c) (Some b) (mark_ca m) v w :: Item (ZSide c b) (Some a) (mark_bc m) v w :: r) /\
      brought s' = c :: brought s /\ used s' = use (mark_ab m) i (used s) /\
      rises s' = add_rise judge v (rings_ab t) i (rises s)) \/
   (exists j r, Permutation (front s) (i :: j :: r) /\ item_side j = ZSide b c /\
      legal rule (mark_bc m) a j = true /\
      Permutation (front s') (Item (ZSide a c) (Some b) (mark_ca m) v w :: r) /\
      brought s' = brought s /\ used s' = use (mark_ab m) i (use (mark_bc m) j (used s)) /\
      rises s' = add_rise judge v (rings_ab t) i (add_rise judge v (rings_bc t) j (rises s)))).
Proof.
  unfold step. intros H.
  destruct (Z.ltb_spec 0 (zorient (corner_a t) (corner_b t) (corner_c t))) as [A|]; [|discriminate].
  split; [assumption|].
  destruct (go (corner_a t) (passed s) (ahead s)) as [l [|i r]] eqn:G; [discriminate|].
  apply go_permutes in G. fold (front s) in G.
  destruct (same (corner_a t) _ && same (corner_b t) _ && legal _ _ _ i && told _ _ _) eqn:E; [|discriminate].
  apply andb_prop in E. destruct E as [E W]. apply andb_prop in E. destruct E as [E L]. apply andb_prop in E. destruct E as [Ea Eb].
  apply same_eq in Ea, Eb.
  exists i. split; [|split; [assumption|]].
  { destruct (item_side i) as [x y]. cbn in *. subst. reflexivity. }
  split; [assumption|].
  destruct (before (corner_c t) (corner_b t)) eqn:B.
  - left. destruct (before (corner_a t) (corner_c t)) eqn:B'; [|discriminate].
    injection H as <-. exists (l ++ r). cbn. rewrite G. repeat split; try reflexivity.
    + symmetry. apply Permutation_middle.
    + unfold front; cbn. rewrite <- Permutation_middle. constructor.
      rewrite <- Permutation_middle. reflexivity.
  - right. destruct r as [|j r]; [discriminate|].
    destruct (same (corner_b t) _ && same (corner_c t) _ && legal _ _ _ j) eqn:F; [|discriminate].
    apply andb_prop in F. destruct F as [F M]. apply andb_prop in F. destruct F as [Fb Fc].
    apply same_eq in Fb, Fc.
    injection H as <-. exists j, (l ++ r). cbn. rewrite G. repeat split; try reflexivity; try assumption.
    + rewrite <- Permutation_middle. constructor. rewrite <- Permutation_middle. reflexivity.
    + destruct (item_side j) as [x y]. cbn in *. subst. reflexivity.
    + unfold front; cbn. rewrite <- Permutation_middle. reflexivity.
Qed.

(* The ends of the sides of the lower hull. *)
Definition ends_of (l : list zside) : list zpoint := flat_map (fun x => [left_end x; right_end x]) l.

Lemma ends_of_in l p : In p (ends_of l) <-> exists x, In x l /\ (p = left_end x \/ p = right_end x).
Proof.
  unfold ends_of. rewrite in_flat_map. split; intros (x & I & E); exists x; (split; [assumption|]); cbn in *; intuition.
Qed.

(* Another side x of the lower hull comes to the front, with the points ps. *)
Definition adds (x : zside) (ps : list zpoint) (s s' : state) : Prop :=
  before (left_end x) (right_end x) = true /\ Permutation (front s') (first_item x :: front s) /\
  brought s' = ps ++ brought s /\ used s' = used s /\ rises s' = rises s.

(* The states to which a lower hull, with its two ends, and triangles lead. *)
Inductive grown (rule : bool) (judge : option table) :
  list zside -> option (zside * zside) -> list ztriangle -> state -> Prop :=
| grown_start : grown rule judge [] None [] (State [] [] [] [] [])
| grown_triangle low ends ts s t s' : grown rule judge low ends ts s -> step rule judge t s = Some s' ->
    grown rule judge low ends (ts ++ [t]) s'
| grown_first ts s x s' : grown rule judge [] None ts s -> adds x [left_end x; right_end x] s s' ->
    grown rule judge [x] (Some (x, x)) ts s'
| grown_left low f l ts s x s' : grown rule judge low (Some (f, l)) ts s -> joins x f = true ->
    adds x [left_end x] s s' -> grown rule judge (x :: low) (Some (x, l)) ts s'
| grown_right low f l ts s x s' : grown rule judge low (Some (f, l)) ts s -> joins l x = true ->
    adds x [right_end x] s s' -> grown rule judge (low ++ [x]) (Some (f, x)) ts s'.

Section Laid.
Variable u : R.
Hypothesis u_positive : 0 < u.
Variable rule : bool.
Variable judge : option table.

Notation at_left i := (place u (left_end (item_side i))).
Notation at_right i := (place u (right_end (item_side i))).
Notation tri := (place_triangle u).

(* The side ab of triangles a, b, c and b, a, d needs no flip. *)
Definition tie_kept (a b c d : point) : Prop := first_of a [a; b; c; d] \/ first_of b [a; b; c; d].
Definition fine (used : list zside) (a b c d : point) : Prop :=
  (exists s, In s used /\ ((place u (left_end s) = a /\ place u (right_end s) = b) \/
                           (place u (left_end s) = b /\ place u (right_end s) = a))) \/
  (circle a b c d <= 0 /\ (rule = true -> circle a b c d = 0 -> tie_kept a b c d)).

Lemma fine_turn used a b c d : fine used a b c d -> fine used b a d c.
Proof.
  intros [[s [I H]]|[C H]]; [left; exists s; tauto|right].
  assert (E : circle b a d c = circle a b c d) by (unfold circle; flat; ring).
  rewrite E. split; [assumption|]. intros R Z. specialize (H R Z).
  unfold tie_kept, first_of in *. cbn in *. destruct H as [H|H]; [right|left]; intros x Hx; apply H; tauto.
Qed.

Lemma fine_more used used' a b c d : incl used used' -> fine used a b c d -> fine used' a b c d.
Proof. intros I [[s [J H]]|H]; [left; exists s; split; [apply I|]; assumption|right; assumption]. Qed.

Record laid (low : list zside) (done : list ztriangle) (s : state) : Prop := {
  l_positive : forall t, In t done -> positive (tri t);
  l_count : forall q, (total (fun t => count q (tri t)) done + total (fun i => above (at_left i) (at_right i) q)
    (front s)
    = total (fun s => above (place u (left_end s)) (place u (right_end s)) q) low)%Z;
  l_order : forall i, In i (front s) -> lex (at_left i) (at_right i);
  l_below : forall i, In i (front s) ->
    match below i with
    | None => In (item_side i) low /\ marked i = false
    | Some d => exists t, In t done /\ turned (tri t) (at_right i) (at_left i) (place u d)
    end;
  l_sides : forall t a b c, In t done -> turned (tri t) a b c ->
    (exists i d, In i (front s) /\ below i = Some d /\ a = at_right i /\ b = at_left i /\ c = place u d) \/
    (exists s, In s low /\ a = place u (left_end s) /\ b = place u (right_end s)) \/
    (exists t d, In t done /\ turned (tri t) b a d /\ fine (used s) a b c d);
  l_used : forall x, In x (used s) ->
    exists t c, In t done /\ turned (tri t) (place u (left_end x)) (place u (right_end x)) c;
  l_low : forall x, In x low -> (exists i, In i (front s) /\ item_side i = x /\ below i = None) \/
    exists t c, In t done /\ turned (tri t) (place u (left_end x)) (place u (right_end x)) c;
  l_brought : forall p, In p (brought s) -> In p (ends_of low) \/ exists t, In t done /\ corner (place u p) (tri t);
  l_ends : forall i, In i (front s) ->
    In (left_end (item_side i)) (brought s) /\ In (right_end (item_side i)) (brought s);
  l_corners : forall t, In t done ->
    In (corner_a t) (brought s) /\ In (corner_b t) (brought s) /\ In (corner_c t) (brought s);
  l_up : forall k m w, 0 <= m -> (forall p, In p (ends_of low) -> 0 <= affine k m w (place u p)) ->
    forall p, In p (brought s) -> 0 <= affine k m w (place u p);
  l_down : forall k m w, m <= 0 ->
    (forall i, In i (front s) -> 0 <= affine k m w (at_left i) /\ 0 <= affine k m w (at_right i)) ->
    forall p, In p (brought s) -> 0 <= affine k m w (place u p)
}.

(* A corner over or under the opposite side. *)
Lemma over_side k m w a b c : lex a b -> orient a b c <> 0 -> lex a c -> lex c b -> 0 <= m * orient a b c ->
  0 <= affine k m w a -> 0 <= affine k m w b -> 0 <= affine k m w c.
Proof.
  intros B N Bc Cb M Ha Hb.
  assert (D : X a < X b).
  { destruct B as [|[E _]]; [assumption|exfalso]. apply N.
    assert (X a = X c) by (unfold lex in *; lra). unfold orient. rewrite <- E, <- H. ring. }
  assert (E : (X b - X a) * affine k m w c
     = (X b - X c) * affine k m w a + (X c - X a) * affine k m w b + m * orient a b c)
    by (unfold affine; flat; ring).
  assert (X a <= X c <= X b) by (unfold lex in *; lra).
  assert (0 <= (X b - X c) * affine k m w a) by (apply Rmult_le_pos; lra).
  assert (0 <= (X c - X a) * affine k m w b) by (apply Rmult_le_pos; lra).
  apply Rmult_le_reg_l with (X b - X a); lra.
Qed.

Lemma legal_fine m c i d (use_side : list zside) : legal rule m c i = true -> below i = Some d ->
  (m = true -> In (item_side i) use_side) ->
  fine use_side (at_left i) (at_right i) (place u c) (place u d).
Proof.
  unfold legal. intros L B I. rewrite B in L. destruct m; [left; exists (item_side i); auto|].
  destruct (marked i); [discriminate|]. right. rewrite place_circle.
  assert (U : 0 < u * u * (u * u)) by (assert (0 < u * u) by nra; nra).
  set (z := zcircle _ _ _ _) in *.
  destruct (Z.compare_spec z 0) as [E|E|E]; [| |discriminate].
  - rewrite E. split; [lra|]. intros R _. rewrite R in L. cbn in L. unfold tie_is_right in L.
    apply andb_prop in L. destruct L as [Lc Ld].
    destruct (zfirst (left_end (item_side i)) (right_end (item_side i))) eqn:F;
    apply (zfirst_first u u_positive) in Lc, Ld.
    + apply (zfirst_first u u_positive) in F. left. intros x [|[|[|[|[]]]]]; subst; auto.
    + right. intros x [|[|[|[|[]]]]]; subst; auto.
      destruct (first_total (at_left i) (at_right i)) as [G|[G|G]]; auto; exfalso;
        assert (zfirst (left_end (item_side i)) (right_end (item_side i)) = true)
        by (apply (zfirst_first u u_positive); auto); congruence.
  - apply IZR_lt in E. split; [nra|intros; nra].
Qed.

Lemma use_incl m i l : incl l (use m i l).
Proof. unfold use. destruct m; [apply incl_tl|]; apply incl_refl. Qed.

Lemma use_in m i l x : In x (use m i l) -> x = item_side i \/ In x l.
Proof. unfold use. destruct m; cbn; intuition. Qed.

Lemma use_marked m i l : m = true -> In (item_side i) (use m i l).
Proof. intros ->; cbn; auto. Qed.

(* A side of the front that has been covered by the triangle t0. *)
Lemma covered low done s t0 i m c l : laid low done s -> In i (front s) -> legal rule m c i = true ->
  (m = true -> In (item_side i) l) -> turned (tri t0) (at_left i) (at_right i) (place u c) ->
  (exists x, In x low /\ at_left i = place u (left_end x) /\ at_right i = place u (right_end x)) \/
  (exists t d, In t done /\ turned (tri t) (at_right i) (at_left i) d /\ fine l (at_left i) (at_right i) (place u c) d).
Proof.
  intros H I L M T. pose proof (l_below _ _ _ H i I) as B.
  destruct (below i) as [d|] eqn:E.
  - destruct B as [t [It Tt]]. right. exists t, (place u d). repeat split; try assumption.
    apply legal_fine with m; assumption.
  - left. exists (item_side i). tauto.
Qed.

Lemma laid_step low done s t s' : laid low done s -> step rule judge t s = Some s' -> laid low (t :: done) s'.
Proof.
  intros H E. apply step_cases in E. cbn zeta in E. destruct E as (A & i & Ei & Li & _ & E).
  apply (place_orient_positive u u_positive) in A.
  set (a := corner_a t) in *. set (b := corner_b t) in *. set (c := corner_c t) in *.
  set (m := marks t) in *. set (v := value t) in *.
  assert (Tab : turned (tri t) (place u a) (place u b) (place u c)) by (left; reflexivity).
  assert (Tbc : turned (tri t) (place u b) (place u c) (place u a)) by (apply turned_next; assumption).
  assert (Tca : turned (tri t) (place u c) (place u a) (place u b)) by (apply turned_next; assumption).
  destruct E as [(r & P & Bac & Bcb & P' & Br & Us & Ri) | (j & r & P & Ej & Lj & P' & Br & Us & Ri)].
  - (* one lower side, and a new point c above it *)
    apply (before_lex u u_positive) in Bac, Bcb.
    set (w0 := enter judge (rings_ab t) i) in *.
    set (n1 := Item (ZSide a c) (Some b) (mark_ca m) v w0) in *. set (n2 := Item (ZSide c b) (Some a) (mark_bc m) v w0) in *.
    assert (Ii : In i (front s)) by (apply (Permutation_in _ (Permutation_sym P)); left; reflexivity).
    assert (Old : forall x, In x r -> In x (front s))
      by (intros; apply (Permutation_in _ (Permutation_sym P)); right; assumption).
    assert (Back : forall x, In x (front s) -> x = i \/ In x r)
      by (intros x Hx; apply (Permutation_in _ P) in Hx; cbn in Hx; intuition).
    assert (New : forall x, In x (front s') -> x = n1 \/ x = n2 \/ In x r)
      by (intros x Hx; apply (Permutation_in _ P') in Hx; cbn in Hx; intuition).
    assert (Has : forall x, x = n1 \/ x = n2 \/ In x r -> In x (front s'))
      by (intros x Hx; apply (Permutation_in _ (Permutation_sym P')); cbn; intuition).
    assert (Cov : (exists x, In x low /\ at_left i = place u (left_end x) /\ at_right i = place u (right_end x)) \/
      (exists t d, In t done /\ turned (tri t) (at_right i) (at_left i) d /\
         fine (used s') (at_left i) (at_right i) (place u c) d)).
    { apply (covered low done s t _ (mark_ab m)); try assumption; [|rewrite Ei; assumption].
      rewrite Us. apply use_marked. }
    assert (More : incl (used s) (used s')) by (rewrite Us; apply use_incl).
    destruct (l_ends _ _ _ H i Ii) as [Ha Hb]. rewrite Ei in Ha, Hb; cbn in Ha, Hb.
    split.
    + intros x [<-|Hx]; [assumption | apply (l_positive _ _ _ H); assumption].
    + intros q. pose proof (l_count _ _ _ H q) as C. rewrite (total_permutation _ _ _ P) in C.
      rewrite (total_permutation _ _ _ P'), !total_cons. rewrite total_cons, Ei in C.
      unfold n1, n2. cbn [item_side left_end right_end] in *.
      assert (K : count q (tri t) = (above (place u a) (place u b) q - above (place u c) (place u b) q
        - above (place u a) (place u c) q)%Z); [|lia].
      unfold place_triangle, count, signed. fold a b c.
      rewrite (above_right (place u b) (place u a)) by (unfold lex in *; lra).
      rewrite (above_right (place u b) (place u c)) by (unfold lex in *; lra).
      rewrite (above_right (place u c) (place u a)) by (unfold lex in *; lra). lia.
    + intros x Hx. apply New in Hx. destruct Hx as [->|[->|Hx]]; [assumption | assumption |].
      apply (l_order _ _ _ H); auto.
    + intros x Hx. apply New in Hx. destruct Hx as [->|[->|Hx]]; cbn.
      * exists t. auto.
      * exists t. auto.
      * pose proof (l_below _ _ _ H x (Old x Hx)) as B. destruct (below x); [|assumption].
        destruct B as [t' [I T]]. exists t'. auto.
    + intros x a' b' c' [<-|Hx] T.
      * destruct (turned_three _ _ _ _ _ _ _ Tab T) as [(->&->&->)|[(->&->&->)|(->&->&->)]].
        -- right. rewrite Ei in Cov; cbn in Cov. destruct Cov as [Cov|(t' & d & I & T' & F)]; [left; assumption|].
           right. exists t', d. repeat split; auto. right; assumption.
        -- left. exists n2, a. repeat split; auto.
        -- left. exists n1, b. repeat split; auto.
      * destruct (l_sides _ _ _ H x a' b' c' Hx T) as [(k & d & I & B & -> & -> & ->)|[L|(t' & d & I & T' & F)]].
        -- apply Back in I. destruct I as [->|I].
           ++ right. right. exists t, (place u c). split; [left; reflexivity|]. split; [rewrite Ei; assumption|].
              apply fine_turn. apply legal_fine with (mark_ab m); try assumption. rewrite Us. apply use_marked.
           ++ left. exists k, d. repeat split; auto.
        -- right. left. assumption.
        -- right. right. exists t', d. repeat split; auto. { right; assumption. }
           apply fine_more with (used s); assumption.
    + intros x Hx. rewrite Us in Hx. apply use_in in Hx. destruct Hx as [->|Hx].
      * rewrite Ei. exists t, (place u c). split; [left; reflexivity | assumption].
      * destruct (l_used _ _ _ H x Hx) as (t' & d & I & T). exists t', d. split; [right|]; assumption.
    + intros x Hx. destruct (l_low _ _ _ H x Hx) as [(k & I & S & B)|(t' & d & I & T)].
      * apply Back in I. destruct I as [->|I].
        -- right. exists t, (place u c). split; [left; reflexivity|]. rewrite <- S, Ei. assumption.
        -- left. exists k. auto.
      * right. exists t', d. split; [right|]; assumption.
    + intros p Hp. rewrite Br in Hp. destruct Hp as [<-|Hp].
      * right. exists t. split; [left; reflexivity|]. cbn. auto.
      * destruct (l_brought _ _ _ H p Hp) as [|(t' & I & C)]; [left; assumption|].
        right. exists t'. split; [right|]; assumption.
    + intros x Hx. rewrite Br. apply New in Hx. destruct Hx as [->|[->|Hx]]; cbn; auto.
      destruct (l_ends _ _ _ H x (Old x Hx)); auto.
    + intros x Hx. rewrite Br. destruct Hx as [<-|Hx]; cbn; auto.
      destruct (l_corners _ _ _ H x Hx) as (? & ? & ?); auto.
    + intros k m' w M Hl p Hp. rewrite Br in Hp. destruct Hp as [<-|Hp]; [|exact (l_up _ _ _ H k m' w M Hl p Hp)].
      apply over_side with (place u a) (place u b); try assumption; try lra.
      * apply lex_transitive with (place u c); assumption.
      * apply Rmult_le_pos; lra.
      * exact (l_up _ _ _ H k m' w M Hl a Ha).
      * exact (l_up _ _ _ H k m' w M Hl b Hb).
    + intros k m' w M Hf p Hp. rewrite Br in Hp.
      pose proof (Hf n1 (Has n1 (or_introl eq_refl))) as [G1 G2].
      pose proof (Hf n2 (Has n2 (or_intror (or_introl eq_refl)))) as [G3 G4]. cbn in G1, G2, G3, G4.
      destruct Hp as [<-|Hp]; [assumption|].
      refine (l_down _ _ _ H k m' w M _ p Hp). intros x Hx. apply Back in Hx. destruct Hx as [->|Hx].
      * rewrite Ei; cbn. auto.
      * apply Hf. auto.
  - (* two lower sides, and b goes off the front *)
    set (n1 := Item (ZSide a c) (Some b) (mark_ca m) v (enter judge (rings_ab t) i)) in *.
    assert (Ii : In i (front s)) by (apply (Permutation_in _ (Permutation_sym P)); left; reflexivity).
    assert (Ij : In j (front s)) by (apply (Permutation_in _ (Permutation_sym P)); right; left; reflexivity).
    assert (Old : forall x, In x r -> In x (front s))
      by (intros; apply (Permutation_in _ (Permutation_sym P)); right; right; assumption).
    assert (Back : forall x, In x (front s) -> x = i \/ x = j \/ In x r)
      by (intros x Hx; apply (Permutation_in _ P) in Hx; cbn in Hx; intuition).
    assert (New : forall x, In x (front s') -> x = n1 \/ In x r)
      by (intros x Hx; apply (Permutation_in _ P') in Hx; cbn in Hx; intuition).
    assert (Has : forall x, x = n1 \/ In x r -> In x (front s'))
      by (intros x Hx; apply (Permutation_in _ (Permutation_sym P')); cbn; intuition).
    pose proof (l_order _ _ _ H i Ii) as Bab. pose proof (l_order _ _ _ H j Ij) as Bbc.
    rewrite Ei in Bab. rewrite Ej in Bbc. cbn in Bab, Bbc.
    assert (More : incl (used s) (used s')).
    { rewrite Us. eapply incl_tran; [apply use_incl|apply use_incl]. }
    assert (Mi : mark_ab m = true -> In (item_side i) (used s')) by (rewrite Us; apply use_marked).
    assert (Mj : mark_bc m = true -> In (item_side j) (used s')).
    { rewrite Us. intros M. apply use_incl. apply use_marked. assumption. }
    assert (Covi : (exists x, In x low /\ at_left i = place u (left_end x) /\ at_right i = place u (right_end x)) \/
      (exists t d, In t done /\ turned (tri t) (at_right i) (at_left i) d /\
         fine (used s') (at_left i) (at_right i) (place u c) d)).
    { apply (covered low done s t _ (mark_ab m)); try assumption. rewrite Ei; assumption. }
    assert (Covj : (exists x, In x low /\ at_left j = place u (left_end x) /\ at_right j = place u (right_end x)) \/
      (exists t d, In t done /\ turned (tri t) (at_right j) (at_left j) d /\
         fine (used s') (at_left j) (at_right j) (place u a) d)).
    { apply (covered low done s t _ (mark_bc m)); try assumption. rewrite Ej; assumption. }
    destruct (l_ends _ _ _ H i Ii) as [Ha Hb]. rewrite Ei in Ha, Hb; cbn in Ha, Hb.
    destruct (l_ends _ _ _ H j Ij) as [_ Hc]. rewrite Ej in Hc; cbn in Hc.
    split.
    + intros x [<-|Hx]; [assumption | apply (l_positive _ _ _ H); assumption].
    + intros q. pose proof (l_count _ _ _ H q) as C. rewrite (total_permutation _ _ _ P) in C.
      rewrite (total_permutation _ _ _ P'), !total_cons. rewrite !total_cons, Ei, Ej in C.
      unfold n1. cbn [item_side left_end right_end] in *.
      assert (K : count q (tri t) = (above (place u a) (place u b) q + above (place u b) (place u c) q
        - above (place u a) (place u c) q)%Z); [|lia].
      unfold place_triangle, count, signed. fold a b c.
      rewrite (above_right (place u b) (place u a)) by (unfold lex in *; lra).
      rewrite (above_right (place u c) (place u b)) by (unfold lex in *; lra).
      rewrite (above_right (place u c) (place u a)) by (unfold lex in *; lra). lia.
    + intros x Hx. apply New in Hx. destruct Hx as [->|Hx]; [apply lex_transitive with (place u b); assumption|].
      apply (l_order _ _ _ H); auto.
    + intros x Hx. apply New in Hx. destruct Hx as [->|Hx]; cbn.
      * exists t. auto.
      * pose proof (l_below _ _ _ H x (Old x Hx)) as B. destruct (below x); [|assumption].
        destruct B as [t' [I T]]. exists t'. auto.
    + intros x a' b' c' [<-|Hx] T.
      * destruct (turned_three _ _ _ _ _ _ _ Tab T) as [(->&->&->)|[(->&->&->)|(->&->&->)]].
        -- right. rewrite Ei in Covi; cbn in Covi. destruct Covi as [Cov|(t' & d & I & T' & F)]; [left; assumption|].
           right. exists t', d. repeat split; auto. right; assumption.
        -- right. rewrite Ej in Covj; cbn in Covj. destruct Covj as [Cov|(t' & d & I & T' & F)]; [left; assumption|].
           right. exists t', d. repeat split; auto. right; assumption.
        -- left. exists n1, b. repeat split; auto.
      * destruct (l_sides _ _ _ H x a' b' c' Hx T) as [(k & d & I & B & -> & -> & ->)|[L|(t' & d & I & T' & F)]].
        -- apply Back in I. destruct I as [->|[->|I]].
           ++ right. right. exists t, (place u c). split; [left; reflexivity|]. split; [rewrite Ei; assumption|].
              apply fine_turn. apply legal_fine with (mark_ab m); assumption.
           ++ right. right. exists t, (place u a). split; [left; reflexivity|]. split; [rewrite Ej; assumption|].
              apply fine_turn. apply legal_fine with (mark_bc m); assumption.
           ++ left. exists k, d. repeat split; auto.
        -- right. left. assumption.
        -- right. right. exists t', d. repeat split; auto. { right; assumption. }
           apply fine_more with (used s); assumption.
    + intros x Hx. rewrite Us in Hx. apply use_in in Hx. destruct Hx as [->|Hx].
      * rewrite Ei. exists t, (place u c). split; [left; reflexivity | assumption].
      * apply use_in in Hx. destruct Hx as [->|Hx].
        -- rewrite Ej. exists t, (place u a). split; [left; reflexivity | assumption].
        -- destruct (l_used _ _ _ H x Hx) as (t' & d & I & T). exists t', d. split; [right|]; assumption.
    + intros x Hx. destruct (l_low _ _ _ H x Hx) as [(k & I & S & B)|(t' & d & I & T)].
      * apply Back in I. destruct I as [->|[->|I]].
        -- right. exists t, (place u c). split; [left; reflexivity|]. rewrite <- S, Ei. assumption.
        -- right. exists t, (place u a). split; [left; reflexivity|]. rewrite <- S, Ej. assumption.
        -- left. exists k. auto.
      * right. exists t', d. split; [right|]; assumption.
    + intros p Hp. rewrite Br in Hp. destruct (l_brought _ _ _ H p Hp) as [|(t' & I & C)]; [left; assumption|].
      right. exists t'. split; [right|]; assumption.
    + intros x Hx. rewrite Br. apply New in Hx. destruct Hx as [->|Hx]; cbn; auto.
      apply (l_ends _ _ _ H); auto.
    + intros x Hx. rewrite Br. destruct Hx as [<-|Hx]; auto. apply (l_corners _ _ _ H); assumption.
    + intros k m' w M Hl p Hp. rewrite Br in Hp. exact (l_up _ _ _ H k m' w M Hl p Hp).
    + intros k m' w M Hf p Hp. rewrite Br in Hp.
      pose proof (Hf n1 (Has n1 (or_introl eq_refl))) as [G1 G2]. cbn in G1, G2.
      assert (Gb : 0 <= affine k m' w (place u b)).
      { assert (orient (place u a) (place u c) (place u b) = - orient (place u a) (place u b) (place u c))
          by (unfold orient; ring).
        apply over_side with (place u a) (place u c); try assumption; try lra.
        - apply lex_transitive with (place u b); assumption.
        - nra. }
      refine (l_down _ _ _ H k m' w M _ p Hp). intros x Hx. apply Back in Hx. destruct Hx as [->|[->|Hx]].
      * rewrite Ei; cbn. auto.
      * rewrite Ej; cbn. auto.
      * apply Hf. auto.
Qed.

Lemma laid_lower low low' ps done s x s' : laid low done s -> adds x ps s s' -> Permutation low' (x :: low) ->
  incl ps [left_end x; right_end x] -> In (left_end x) (brought s') -> In (right_end x) (brought s') -> laid low' done s'.
Proof.
  intros H (B & P & Br & Us & _) L I Il Ir. apply (before_lex u u_positive) in B.
  assert (New : forall i, In i (front s') -> i = first_item x \/ In i (front s))
    by (intros i Hi; apply (Permutation_in _ P) in Hi; cbn in Hi; intuition).
  assert (Has : forall i, i = first_item x \/ In i (front s) -> In i (front s'))
    by (intros i Hi; apply (Permutation_in _ (Permutation_sym P)); cbn; intuition).
  assert (Low : forall y, In y low' <-> y = x \/ In y low).
  { intros y. split; intros Hy.
    - apply (Permutation_in _ L) in Hy. cbn in Hy. intuition.
    - apply (Permutation_in _ (Permutation_sym L)). cbn. intuition. }
  assert (End : forall p, In p (ends_of low') <-> p = left_end x \/ p = right_end x \/ In p (ends_of low)).
  { intros p. rewrite !ends_of_in. split.
    - intros (y & Hy & E). apply Low in Hy. destruct Hy as [->|Hy]; [tauto|]. right; right. exists y. auto.
    - intros [->|[->|(y & Hy & E)]]; [exists x|exists x|exists y]; rewrite Low; auto. }
  split.
  - apply (l_positive _ _ _ H).
  - intros q. rewrite (total_permutation _ _ _ P), (total_permutation _ _ _ L), !total_cons.
    pose proof (l_count _ _ _ H q). cbn [first_item item_side]. lia.
  - intros i Hi. apply New in Hi. destruct Hi as [->|Hi]; [assumption|]. apply (l_order _ _ _ H); assumption.
  - intros i Hi. apply New in Hi. destruct Hi as [->|Hi]; [cbn; rewrite Low; auto|].
    pose proof (l_below _ _ _ H i Hi) as W. destruct (below i); [assumption|]. rewrite Low. tauto.
  - intros t a b c Ht T. destruct (l_sides _ _ _ H t a b c Ht T) as [(i & d & Hi & W)|[(y & Hy & W)|W]].
    + left. exists i, d. auto.
    + right. left. exists y. rewrite Low. auto.
    + right. right. rewrite Us. assumption.
  - intros y Hy. rewrite Us in Hy. apply (l_used _ _ _ H y Hy).
  - intros y Hy. apply Low in Hy. destruct Hy as [->|Hy]; [left; exists (first_item x); auto|].
    destruct (l_low _ _ _ H y Hy) as [(i & Hi & W)|W]; [left; exists i; auto|right; assumption].
  - intros p Hp. rewrite End. rewrite Br in Hp. apply in_app_or in Hp. destruct Hp as [Hp|Hp].
    + apply I in Hp. cbn in Hp. intuition.
    + destruct (l_brought _ _ _ H p Hp); auto.
  - intros i Hi. apply New in Hi. destruct Hi as [->|Hi]; [auto|]. rewrite Br, !in_app_iff.
    destruct (l_ends _ _ _ H i Hi). auto.
  - intros t Ht. rewrite Br, !in_app_iff. destruct (l_corners _ _ _ H t Ht) as (? & ? & ?). auto.
  - intros k m w M Hl p Hp. rewrite Br in Hp. apply in_app_or in Hp. destruct Hp as [Hp|Hp].
    + apply Hl, End. apply I in Hp. cbn in Hp. intuition.
    + apply (l_up _ _ _ H k m w M); [|assumption]. intros z Hz. apply Hl, End. auto.
  - intros k m w M Hf p Hp. rewrite Br in Hp. apply in_app_or in Hp. destruct Hp as [Hp|Hp].
    + destruct (Hf (first_item x)) as [Fl Fr]; [auto|]. cbn in Fl, Fr. apply I in Hp. cbn in Hp.
      destruct Hp as [<-|[<-|[]]]; assumption.
    + apply (l_down _ _ _ H k m w M); [|assumption]. intros i Hi. apply Hf. auto.
Qed.

(* The points of the lower hull are there. *)
Lemma grown_ends low ends ts s : grown rule judge low ends ts s -> incl (ends_of low) (brought s) /\
  match ends with Some (f, l) => In f low /\ In l low | None => low = [] end.
Proof.
  induction 1 as [|low ends ts s t s' G [I E] S|ts s x s' G _ A|low f l ts s x s' G [I E] J A|low f l ts s x s' G [I E] J A].
  - split; [intros p []|reflexivity].
  - split; [|assumption]. intros p P. apply I in P. apply step_cases in S. cbn zeta in S.
    destruct S as (_ & i & _ & _ & _ & [(r & _ & _ & _ & _ & -> & _)|(j & r & _ & _ & _ & _ & -> & _)]); cbn; auto.
  - destruct A as (_ & _ & -> & _). split; [|cbn; auto]. intros p P. cbn in *. intuition.
  - destruct A as (_ & _ & -> & _). apply andb_prop in J. destruct J as [J _]. apply same_eq in J.
    split; [|cbn; intuition]. intros p P. cbn in P. cbn. destruct P as [<-|[<-|P]]; auto.
    right. apply I, ends_of_in. exists f. intuition.
  - destruct A as (_ & _ & -> & _). apply andb_prop in J. destruct J as [J _]. apply same_eq in J.
    split; [|rewrite !in_app_iff; cbn; intuition]. intros p P. apply ends_of_in in P. destruct P as (y & Y & P).
    apply in_app_or in Y. destruct Y as [Y|[<-|[]]].
    + right. apply I, ends_of_in. exists y. auto.
    + destruct P as [->| ->]; [right|left; reflexivity]. apply I, ends_of_in. exists l. intuition.
Qed.

Lemma grown_laid low ends ts s : grown rule judge low ends ts s ->
  exists done, laid low done s /\ Permutation done ts.
Proof.
  intros G. assert (E := grown_ends _ _ _ _ G).
  induction G as [|low ends ts s t s' G IH S|ts s x s' G IH A|low f l ts s x s' G IH J A|low f l ts s x s' G IH J A].
  - exists []. split; [|reflexivity]. split; try (intros; contradiction). intros q. reflexivity.
  - destruct (IH (grown_ends _ _ _ _ G)) as (done & L & P). exists (t :: done).
    split; [apply laid_step with s; assumption|]. rewrite P. apply Permutation_cons_append.
  - destruct (IH (grown_ends _ _ _ _ G)) as (done & L & P). exists done. split; [|assumption].
    apply (laid_lower [] _ _ _ _ _ _ L A); [reflexivity|apply incl_refl| |]; apply E; cbn; auto.
  - destruct (IH (grown_ends _ _ _ _ G)) as (done & L & P). exists done. split; [|assumption].
    apply (laid_lower low _ _ _ _ _ _ L A); [reflexivity|intros p [<-|[]]; cbn; auto| |]; apply E; cbn; auto.
  - destruct (IH (grown_ends _ _ _ _ G)) as (done & L & P). exists done. split; [|assumption].
    apply (laid_lower low _ _ _ _ _ _ L A); [symmetry; apply Permutation_cons_append|intros p [<-|[]]; cbn; auto| |];
      apply E, ends_of_in; exists x; rewrite in_app_iff; cbn; auto.
Qed.
End Laid.
