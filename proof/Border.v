(* The border of the hull: two chains from left to right. A chain that turns to one side everywhere lies on that side of
   all its sides, and each x between its ends belongs to one of its sides. *)
Require Import Reals ZArith List Lra Lia Bool.
Require Import Spec Geometry Check Place Count.
Import ListNotations.
Open Scope R_scope.

Definition rightward (x y : R) : Prop := 0 < x \/ (x = 0 /\ 0 < y).

Lemma turn_transitive s ux uy vx vy wx wy : s = 1 \/ s = -1 ->
  rightward ux uy -> rightward vx vy -> rightward wx wy ->
  0 <= s * (ux * vy - uy * vx) -> 0 <= s * (vx * wy - vy * wx) -> 0 <= s * (ux * wy - uy * wx).
Proof.
  intros S U V W A B. unfold rightward in *.
  assert (U' : 0 <= ux) by lra. assert (W' : 0 <= wx) by lra.
  destruct V as [V|[V V']].
  - assert (E : vx * (s * (ux * wy - uy * wx)) = ux * (s * (vx * wy - vy * wx))
      + wx * (s * (ux * vy - uy * vx))) by ring.
    assert (0 <= ux * (s * (vx * wy - vy * wx))) by (apply Rmult_le_pos; assumption).
    assert (0 <= wx * (s * (ux * vy - uy * vx))) by (apply Rmult_le_pos; assumption).
    apply Rmult_le_reg_l with vx; lra.
  - subst vx. destruct S as [-> | ->].
    + assert (wx <= 0) by (apply Rmult_le_reg_l with vy; lra). assert (wx = 0) by lra. subst wx.
      assert (0 < wy) by lra. assert (0 <= ux * wy) by (apply Rmult_le_pos; lra). lra.
    + assert (ux <= 0) by (apply Rmult_le_reg_l with vy; lra). assert (ux = 0) by lra. subst ux.
      assert (0 < uy) by lra. assert (0 <= uy * wx) by (apply Rmult_le_pos; lra). lra.
Qed.

Section Border.
Variable u : R.
Hypothesis u_positive : 0 < u.

Notation left_of s := (place u (left_end s)).
Notation right_of s := (place u (right_end s)).

Definition turn (sign : R) (s t : zside) : Prop :=
  0 <= sign * ((X (right_of s) - X (left_of s)) * (Y (right_of t) - Y (left_of t))
             - (Y (right_of s) - Y (left_of s)) * (X (right_of t) - X (left_of t))).

Lemma chain_inv sign s l : chain sign s l = true -> lex (left_of s) (right_of s) /\
  match l with
  | [] => True
  | t :: r => right_end s = left_end t /\ turn (IZR sign) s t /\ chain sign t r = true
  end.
Proof.
  intros H. destruct l as [|t r]; cbn [chain] in H; apply andb_prop in H; destruct H as [B H];
    apply (before_lex u u_positive) in B; split; auto.
  apply andb_prop in H. destruct H as [H C]. apply andb_prop in H. destruct H as [E T].
  apply same_eq in E. repeat split; auto. apply Z.leb_le in T.
  assert (O : turn (IZR sign) s t <->
    0 <= IZR sign * orient (left_of s) (right_of s) (right_of t)).
  { unfold turn. rewrite E. unfold orient. split; intros; lra. }
  rewrite O, place_orient. apply IZR_le in T. rewrite mult_IZR in T.
  assert (0 < u * u) by nra. nra.
Qed.

Lemma chain_lex sign : forall l s, chain sign s l = true -> forall x, In x (s :: l) -> lex (left_of x) (right_of x).
Proof.
  induction l as [|t r IH]; intros s H x I; apply chain_inv in H; destruct H as [B H].
  - destruct I as [<-|[]]; assumption.
  - destruct H as (_ & _ & C). destruct I as [<-|I]; [assumption|]. apply IH with t; assumption.
Qed.

Lemma lex_rightward a b : lex a b -> rightward (X b - X a) (Y b - Y a).
Proof. unfold lex, rightward. lra. Qed.

Lemma chain_turn sign : sign = 1%Z \/ sign = (-1)%Z -> forall l s, chain sign s l = true ->
  forall x, In x l -> turn (IZR sign) s x.
Proof.
  intros S. induction l as [|t r IH]; intros s H x I; [destruct I|].
  pose proof (chain_lex _ _ _ H) as L. apply chain_inv in H. destruct H as (B & E & T & C).
  destruct I as [<-|I]; [assumption|].
  unfold turn in *. apply turn_transitive with (X (right_of t) - X (left_of t)) (Y (right_of t) - Y (left_of t)).
  - destruct S; subst; auto.
  - apply lex_rightward; assumption.
  - apply lex_rightward. apply L; cbn; auto.
  - apply lex_rightward. apply L; cbn; auto.
  - assumption.
  - apply IH; assumption.
Qed.

Lemma orient_turn_left sign x s : IZR sign * orient (left_of x) (right_of x) (right_of s)
  = IZR sign * orient (left_of x) (right_of x) (left_of s)
    + IZR sign * ((X (right_of x) - X (left_of x)) * (Y (right_of s) - Y (left_of s))
             - (Y (right_of x) - Y (left_of x)) * (X (right_of s) - X (left_of s))).
Proof. unfold orient; ring. Qed.

Lemma chain_ahead sign x : forall l s, chain sign s l = true -> (forall y, In y (s :: l) -> turn (IZR sign) x y) ->
  0 <= IZR sign * orient (left_of x) (right_of x) (left_of s) -> forall y, In y (s :: l) ->
  0 <= IZR sign * orient (left_of x) (right_of x) (left_of y) /\
    0 <= IZR sign * orient (left_of x) (right_of x) (right_of y).
Proof.
  induction l as [|t r IH]; intros s H T O y I;
    pose proof (T s (or_introl eq_refl)) as Ts; unfold turn in Ts;
    pose proof (orient_turn_left sign x s) as E; apply chain_inv in H; destruct H as [B H].
  - destruct I as [<-|[]]. lra.
  - destruct H as (F & _ & C). destruct I as [<-|I]; [lra|].
    apply IH with t; auto.
    + intros z Hz. apply T. cbn; auto.
    + rewrite <- F. lra.
Qed.

Lemma chain_supports sign : sign = 1%Z \/ sign = (-1)%Z -> forall l s, chain sign s l = true ->
  forall x y, In x (s :: l) -> In y (s :: l) ->
  0 <= IZR sign * orient (left_of x) (right_of x) (left_of y) /\
    0 <= IZR sign * orient (left_of x) (right_of x) (right_of y).
Proof.
  intros S. induction l as [|t r IH]; intros s H x y Ix Iy.
  - destruct Ix as [<-|[]], Iy as [<-|[]].
    destruct (orient_same (left_of s) (right_of s)) as [-> ->]. lra.
  - pose proof (chain_turn sign S _ _ H) as T. pose proof (chain_inv _ _ _ H) as (B & E & _ & C).
    destruct Ix as [<-|Ix].
    + destruct Iy as [<-|Iy].
      * destruct (orient_same (left_of s) (right_of s)) as [-> ->]. lra.
      * apply chain_ahead with r t; auto. rewrite <- E.
        destruct (orient_same (left_of s) (right_of s)) as [_ ->]. lra.
    + destruct Iy as [<-|Iy]; [|apply IH with t; assumption].
      destruct (IH t C x t Ix (or_introl eq_refl)) as [P _]. rewrite <- E in P. split; [|assumption].
      specialize (T x Ix). unfold turn in T.
      assert (IZR sign * orient (left_of x) (right_of x) (left_of s) =
        IZR sign * orient (left_of x) (right_of x) (right_of s)
        + IZR sign * ((X (right_of s) - X (left_of s)) * (Y (right_of x) - Y (left_of x))
             - (Y (right_of s) - Y (left_of s)) * (X (right_of x) - X (left_of x)))) by (unfold orient; ring).
      lra.
Qed.

(* How many sides of a chain have a given x: one, between the ends. *)
Definition spans (a b q : point) : Z :=
  if Rle_dec (X a) (X q) then if Rlt_dec (X q) (X b) then 1 else 0 else 0.

Lemma spans_join a b c q : X a <= X b <= X c -> (spans a b q + spans b c q = spans a c q)%Z.
Proof.
  intros. unfold spans. repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); try lia; lra.
Qed.

Lemma above_spans a b q : (0 <= above a b q <= spans a b q)%Z.
Proof. unfold above, spans. repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); lia. Qed.

Lemma chain_ends sign : forall l s, chain sign s l = true -> X (left_of s) <= X (place u (last_end s l)).
Proof.
  induction l as [|t r IH]; intros s H; pose proof (chain_inv _ _ _ H) as [B C]; cbn [last_end].
  - unfold lex in B. lra.
  - destruct C as (E & _ & C). specialize (IH t C). rewrite <- E in IH. unfold lex in B. lra.
Qed.

Lemma chain_range sign : forall l s, chain sign s l = true -> forall x, In x (s :: l) ->
  X (left_of s) <= X (left_of x) <= X (place u (last_end s l)) /\
  X (left_of s) <= X (right_of x) <= X (place u (last_end s l)).
Proof.
  induction l as [|t r IH]; intros s H x I; pose proof (chain_ends _ _ _ H) as N;
    pose proof (chain_inv _ _ _ H) as [B C]; cbn [last_end] in *.
  - destruct I as [<-|[]]. unfold lex in B. lra.
  - destruct C as (E & _ & C). pose proof (chain_ends _ _ _ C) as N'.
    rewrite <- E in N'. unfold lex in B. destruct I as [<-|I]; [lra|].
    specialize (IH t C x I). rewrite <- E in IH. lra.
Qed.

Lemma chain_spans sign q : forall l s, chain sign s l = true ->
  total (fun x => spans (left_of x) (right_of x) q) (s :: l) = spans (left_of s) (place u (last_end s l)) q.
Proof.
  induction l as [|t r IH]; intros s H; pose proof (chain_inv _ _ _ H) as [B C]; rewrite total_cons; cbn [last_end].
  - cbn. lia.
  - destruct C as (E & _ & C). rewrite (IH t C), <- E. apply spans_join.
    pose proof (chain_ends _ _ _ C) as N. rewrite <- E in N. unfold lex in B. lra.
Qed.

Lemma total_le {A} (f g : A -> Z) l : (forall x, In x l -> (f x <= g x)%Z) -> (total f l <= total g l)%Z.
Proof.
  induction l as [|x l IH]; intros H; [cbn; lia|]. rewrite !total_cons.
  pose proof (H x (or_introl eq_refl)). specialize (IH (fun y Hy => H y (or_intror Hy))). lia.
Qed.

Lemma total_eq {A} (f g : A -> Z) l : (forall x, In x l -> f x = g x) -> total f l = total g l.
Proof.
  induction l as [|x l IH]; intros H; [reflexivity|]. rewrite !total_cons, (H x (or_introl eq_refl)).
  rewrite IH; [reflexivity|]. intros; apply H; cbn; auto.
Qed.

Lemma chain_above_one sign q l s : chain sign s l = true ->
  (0 <= total (fun x => above (left_of x) (right_of x) q) (s :: l) <= 1)%Z.
Proof.
  intros H. split.
  - apply total_nonneg. intros. apply above_bounds.
  - etransitivity.
    + apply (total_le _ (fun x => spans (left_of x) (right_of x) q)). intros. apply above_spans.
    + rewrite (chain_spans _ _ _ _ H). unfold spans. repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); lia.
Qed.

Lemma chain_above_all sign q l s : chain sign s l = true ->
  (forall x, In x (s :: l) -> 0 < orient (left_of x) (right_of x) q) ->
  X (left_of s) <= X q < X (place u (last_end s l)) ->
  total (fun x => above (left_of x) (right_of x) q) (s :: l) = 1%Z.
Proof.
  intros H O B. rewrite (total_eq _ (fun x => spans (left_of x) (right_of x) q)).
  - rewrite (chain_spans _ _ _ _ H). unfold spans. repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); lra || lia.
  - intros x I. specialize (O x I). unfold above, spans.
    repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); lra || lia.
Qed.

Lemma chain_above_none q l : (forall x, In x l -> orient (left_of x) (right_of x) q <= 0) ->
  total (fun x => above (left_of x) (right_of x) q) l = 0%Z.
Proof.
  intros O. rewrite (total_eq _ (fun _ => 0%Z)).
  - induction l as [|x l IH]; [reflexivity|]. rewrite total_cons, IH; [reflexivity|]. intros; apply O; cbn; auto.
  - intros x I. specialize (O x I). unfold above. repeat destruct (Rle_dec _ _) || destruct (Rlt_dec _ _); lra || lia.
Qed.
End Border.
