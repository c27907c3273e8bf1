// SPDX-License-Identifier: GPL-3.0-or-later

#include "admmSolver.H"
#include "elementViscosity.H"
#include "UIndirectList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::admmSolver::setTimeStep(const scalar dt)
{
    // Asked for each time, as the shape keeps only the last few factors
    factor_ = &shape_.factor(dt);
    if (dt == deltaT_)
    {
        return;
    }
    deltaT_ = dt;

    const labelList& rowOf = factor_->rowOf();
    const admmControls& controls = shape_.admm();

    springRows_.resize(2*shape_.springs().size());
    forAll(shape_.springs(), springi)
    {
        const edge& ends = shape_.springs()[springi];
        springRows_[2*springi] = rowOf[ends.first()];
        springRows_[2*springi + 1] = rowOf[ends.second()];
    }

    const volumeTerm& term = shape_.elementTerm();
    areaRows_ = labelUIndList(rowOf, term.areaDomains().nodes())();
    shearRows_ = labelUIndList(rowOf, term.shearDomains().nodes())();

    masses_.resize(shape_.nNodes());
    forAll(masses_, nodei)
    {
        masses_[rowOf[nodei]] = shape_.nodeMasses()[nodei];
    }

    springWeights_ = sqr(dt)*shape_.springWeights(dt);
    if (shape_.shearModulus() > 0)
    {
        springWeights_.clear();
    }
    springRatio_ = 1/controls.springWeight;
    springFraction_ = 1/(1 + controls.springWeight);

    areaWeights_ =
        sqr(dt)*controls.areaWeight*shape_.areaStiffness()
       *term.areaDomains().volumes();
    shearWeights_.clear();
    if (shape_.shearModulus() > 0)
    {
        shearWeights_ =
            2*sqr(dt)*shape_.shearModulus()*term.shearDomains().volumes();
    }
    viscousWeights_.clear();
    if (shape_.viscosity() > 0)
    {
        viscousWeights_ =
            dt*elementViscosity::boundRatio*shape_.viscosity()
           *term.shearDomains().volumes();
    }
}


void Foam::fsi::admmSolver::resize(const label lanes)
{
    const label nNodeValues = 2*lanes*shape_.nNodes();
    const label nSprings = shape_.springs().size();

    // Never made smaller, so that steps do not allocate
    if (start_.size() < nNodeValues)
    {
        start_.resize(nNodeValues);
        inertial_.resize(nNodeValues);
        displacement_.resize(nNodeValues);
        current_.resize(nNodeValues);
        lessDrift_.resize(shape_.viscosity() > 0 ? nNodeValues : 0);
        change_.resize(nNodeValues);
        residual_.resize(nNodeValues);
        springDual_.resize(2*lanes*nSprings);
        restLengths_.resize(lanes*nSprings);
        areaDual_.resize
        (
            4*lanes*shape_.elementTerm().areaDomains().size()
        );
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::admmSolver::admmSolver(const shapeTemplate& shape)
:
    shape_(shape),
    stretch_(8, Zero)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::admmSolver::solve
(
    const scalar dt,
    const state& s,
    const labelRange& copies,
    Eigen::MatrixXd& v
)
{
    setTimeStep(dt);
    v.resize(s.positions.rows(), s.positions.cols());
    nIterations_ = 0;
    lastChange_ = 0;

    for (label copyi = copies.start(); copyi <= copies.last();)
    {
        const label left = copies.last() + 1 - copyi;
        const label lanes = left >= 8 ? 8 : left >= 4 ? 4 : left >= 2 ? 2 : 1;
        resize(lanes);
        switch (lanes)
        {
            case 8: solveBlock<8>(s, copyi, v); break;
            case 4: solveBlock<4>(s, copyi, v); break;
            case 2: solveBlock<2>(s, copyi, v); break;
            default: solveBlock<1>(s, copyi, v);
        }
        copyi += lanes;
    }
}


void Foam::fsi::admmSolver::solve
(
    const scalar dt,
    const state& s,
    Eigen::MatrixXd& v
)
{
    solve(dt, s, labelRange(0, s.positions.cols()/2), v);
}


// ************************************************************************* //
