/* forficula, MIT; with three.js and uPlot, MIT: see LICENSES.txt; sources fed1f64f47c201402a0f407d2ec4c2d63ae25dd256d9b2e6fa62a9ba4fa63cfa */
(()=>{function D(n,t={},...e){let i=document.createElement(n);for(let[s,r]of Object.entries(t))s.includes("-")||s==="role"?i.setAttribute(s,r):i[s]=r;return i.append(...e),i}function Za(n){let t="http://www.w3.org/2000/svg",e=document.createElementNS(t,"svg");e.setAttribute("viewBox","0 0 24 24"),e.setAttribute("aria-hidden","true");let i=document.createElementNS(t,"path");return i.setAttribute("d",n),e.append(i),e}function tr({colour:n,dash:t}){let e="http://www.w3.org/2000/svg",i=document.createElementNS(e,"svg");i.setAttribute("viewBox","0 0 24 8"),i.setAttribute("aria-hidden","true"),i.classList.add("sample");let s=document.createElementNS(e,"path");return s.setAttribute("d","M0 4H24"),s.setAttribute("stroke",n),s.setAttribute("stroke-dasharray",t.join(" ")),i.append(s),i}var Vs={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Gs={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},lp=0,_u=1,cp=2;var _a=1,hp=2,ro=3,Hs=0,$n=1,Bn=2,ar=0,oo=1,xu=2,yu=3,vu=4,up=5;var lr=100,fp=101,dp=102,pp=103,mp=104,gp=200,_p=201,xp=202,yp=203,bu=204,Su=205,vp=206,bp=207,Sp=208,Mp=209,wp=210,Ap=211,Tp=212,Ep=213,Cp=214,bl=0,Sl=1,Ml=2,Yr=3,wl=4,Al=5,Tl=6,El=7,Ql=0,Rp=1,Pp=2,qi=0,Mu=1,wu=2,Au=3,Tu=4,Eu=5,Cu=6,Ru=7;var Pu=300,cr=301,ao=302,tc=303,ec=304,Cl=1e3,Gi=1001,Rl=1002,Cn=1003,Ip=1004;var xa=1005;var qn=1006,nc=1007;var ps=1008;var Jn=1009,Iu=1010,Lu=1011,lo=1012,ic=1013,Ci=1014,_i=1015,Ri=1016,sc=1017,rc=1018,hr=1020,Nu=35902,Du=35899,Uu=1021,Ou=1022,Pi=1023,ls=1026,ms=1027,oc=1028,ac=1029,Ws=1030,lc=1031;var cc=1033,ya=33776,va=33777,ba=33778,Sa=33779,hc=35840,uc=35841,fc=35842,dc=35843,pc=36196,mc=37492,gc=37496,_c=37488,xc=37489,Ma=37490,yc=37491,vc=37808,bc=37809,Sc=37810,Mc=37811,wc=37812,Ac=37813,Tc=37814,Ec=37815,Cc=37816,Rc=37817,Pc=37818,Ic=37819,Lc=37820,Nc=37821,Dc=36492,Uc=36494,Oc=36495,Fc=36283,Bc=36284,wa=36285,kc=36286;var Yo=2300,Pl=2301,yl=2302,cu=2303,hu=2400,uu=2401,fu=2402;var Lp=3200;var zc=0,Np=1,gs="",si="srgb",Zo="srgb-linear",Jo="linear",Ae="srgb";var vl=7680,Fu=7681;var Bu=517;var Dp=519,Up=512,Op=513,Fp=514,ku=515,Bp=516,kp=517,zu=518,Vu=519,zp=35044,Aa=35048;var Gu="300 es",gi=2e3,Zr=2001;function j_(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function Q_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Ko(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Vp(){let n=Ko("canvas");return n.style.display="block",n}var Pd={},Jr=null;function Hu(...n){let t="THREE."+n.shift();Jr?Jr("log",t,...n):console.log(t,...n)}function Gp(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function qt(...n){n=Gp(n);let t="THREE."+n.shift();if(Jr)Jr("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function jt(...n){n=Gp(n);let t="THREE."+n.shift();if(Jr)Jr("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Xo(...n){let t=n.join(" ");t in Pd||(Pd[t]=!0,qt(...n))}function Hp(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Wp={[bl]:bl,[Ml]:Tl,[wl]:wl,[Yr]:Al,[Sl]:Sl,[Tl]:Ml,[El]:El,[Al]:Yr},Ei=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Un=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Id=1234567,qo=Math.PI/180,Kr=180/Math.PI;function co(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Un[n&255]+Un[n>>8&255]+Un[n>>16&255]+Un[n>>24&255]+"-"+Un[t&255]+Un[t>>8&255]+"-"+Un[t>>16&15|64]+Un[t>>24&255]+"-"+Un[e&63|128]+Un[e>>8&255]+"-"+Un[e>>16&255]+Un[e>>24&255]+Un[i&255]+Un[i>>8&255]+Un[i>>16&255]+Un[i>>24&255]).toLowerCase()}function de(n,t,e){return Math.max(t,Math.min(e,n))}function Wu(n,t){return(n%t+t)%t}function tx(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function ex(n,t,e){return n!==t?(e-n)/(t-n):0}function $o(n,t,e){return(1-e)*n+e*t}function nx(n,t,e,i){return $o(n,t,1-Math.exp(-e*i))}function ix(n,t=1){return t-Math.abs(Wu(n,t*2)-t)}function sx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function rx(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function ox(n,t){return n+Math.floor(Math.random()*(t-n+1))}function ax(n,t){return n+Math.random()*(t-n)}function lx(n){return n*(.5-Math.random())}function cx(n){n!==void 0&&(Id=n);let t=Id+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function hx(n){return n*qo}function ux(n){return n*Kr}function fx(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function dx(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Xu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function px(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),f=o((t-i)/2),d=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*f,a*c);break;case"YZY":n.set(l*f,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*f,a*h,a*c);break;case"XZX":n.set(a*h,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*h,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*h,a*c);break;default:qt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function qu(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Xp(n,t){if(t.constructor===Float32Array)return n;let e=qu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function qp(n,t){if(t.constructor===Float32Array)return n;let e=qu(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var $u={DEG2RAD:qo,RAD2DEG:Kr,generateUUID:co,clamp:de,euclideanModulo:Wu,mapLinear:tx,inverseLerp:ex,lerp:$o,damp:nx,pingpong:ix,smoothstep:sx,smootherstep:rx,randInt:ox,randFloat:ax,randFloatSpread:lx,seededRandom:cx,degToRad:hx,radToDeg:ux,isPowerOfTwo:fx,ceilPowerOfTwo:dx,floorPowerOfTwo:Xu,setQuaternionFromProperEuler:px,normalize:qp,denormalize:Xp},Yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(de(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},oi=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],f=r[o+0],d=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||l!==f||c!==d||h!==p){let g=l*f+c*d+h*p+u*x;g<0&&(f=-f,d=-d,p=-p,x=-x,g=-g);let m=1-a;if(g<.9995){let _=Math.acos(g),w=Math.sin(_);m=Math.sin(m*_)/w,a=Math.sin(a*_)/w,l=l*m+f*a,c=c*m+d*a,h=h*m+p*a,u=u*m+x*a}else{l=l*m+f*a,c=c*m+d*a,h=h*m+p*a,u=u*m+x*a;let _=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=_,c*=_,h*=_,u*=_}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],f=r[o+1],d=r[o+2],p=r[o+3];return t[e]=a*p+h*u+l*d-c*f,t[e+1]=l*p+h*f+c*u-a*d,t[e+2]=c*p+h*d+a*f-l*u,t[e+3]=h*p-a*u-l*f-c*d,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),f=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"YXZ":this._x=f*h*u+c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"ZXY":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u-f*d*p;break;case"ZYX":this._x=f*h*u-c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u+f*d*p;break;case"YZX":this._x=f*h*u+c*d*p,this._y=c*d*u+f*h*p,this._z=c*h*p-f*d*u,this._w=c*h*u-f*d*p;break;case"XZY":this._x=f*h*u-c*d*p,this._y=c*d*u-f*h*p,this._z=c*h*p+f*d*u,this._w=c*h*u+f*d*p;break;default:qt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=i+a+u;if(f>0){let d=.5/Math.sqrt(f+1);this._w=.25/d,this._x=(h-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>u){let d=2*Math.sqrt(1+i-a-u);this._w=(h-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>u){let d=2*Math.sqrt(1+a-i-u);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+h)/d}else{let d=2*Math.sqrt(1+u-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+h)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(de(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},W=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Ld.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Ld.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Gh.copy(this).projectOnVector(t),this.sub(Gh)}reflect(t){return this.sub(Gh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(de(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Gh=new W,Ld=new oi,ee=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],d=i[5],p=i[8],x=s[0],g=s[3],m=s[6],_=s[1],w=s[4],b=s[7],S=s[2],M=s[5],y=s[8];return r[0]=o*x+a*_+l*S,r[3]=o*g+a*w+l*M,r[6]=o*m+a*b+l*y,r[1]=c*x+h*_+u*S,r[4]=c*g+h*w+u*M,r[7]=c*m+h*b+u*y,r[2]=f*x+d*_+p*S,r[5]=f*g+d*w+p*M,r[8]=f*m+d*b+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,d=c*r-o*l,p=e*u+i*f+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*c-h*i)*x,t[2]=(a*i-s*o)*x,t[3]=f*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=d*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Xo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Hh.makeScale(t,e)),this}rotate(t){return Xo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Hh.makeRotation(-t)),this}translate(t,e){return Xo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Hh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Hh=new ee,Nd=new ee().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Dd=new ee().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function mx(){let n={enabled:!0,workingColorSpace:Zo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ae&&(s.r=as(s.r),s.g=as(s.g),s.b=as(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ae&&(s.r=$r(s.r),s.g=$r(s.g),s.b=$r(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===gs?Jo:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Zo]:{primaries:t,whitePoint:i,transfer:Jo,toXYZ:Nd,fromXYZ:Dd,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:si},outputColorSpaceConfig:{drawingBufferColorSpace:si}},[si]:{primaries:t,whitePoint:i,transfer:Ae,toXYZ:Nd,fromXYZ:Dd,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:si}}}),n}var _e=mx();function as(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function $r(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Nr,Il=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Nr===void 0&&(Nr=Ko("canvas")),Nr.width=t.width,Nr.height=t.height;let s=Nr.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Nr}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Ko("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=as(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(as(e[i]/255)*255):e[i]=as(e[i]);return{data:e,width:t.width,height:t.height}}else return qt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},gx=0,jr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:gx++}),this.uuid=co(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Wh(s[o].image)):r.push(Wh(s[o]))}else r=Wh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Wh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Il.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(qt("Texture: Unable to serialize Texture."),{})}var _x=0,Xh=new W,Zn=class n extends Ei{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Gi,s=Gi,r=qn,o=ps,a=Pi,l=Jn,c=n.DEFAULT_ANISOTROPY,h=gs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:_x++}),this.uuid=co(),this.name="",this.source=new jr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Yt(0,0),this.repeat=new Yt(1,1),this.center=new Yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ee,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Xh).x}get height(){return this.source.getSize(Xh).y}get depth(){return this.source.getSize(Xh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){qt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Pu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Cl:t.x=t.x-Math.floor(t.x);break;case Gi:t.x=t.x<0?0:1;break;case Rl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Cl:t.y=t.y-Math.floor(t.y);break;case Gi:t.y=t.y<0?0:1;break;case Rl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};Zn.DEFAULT_IMAGE=null;Zn.DEFAULT_MAPPING=Pu;Zn.DEFAULT_ANISOTROPY=1;var qe=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],d=l[5],p=l[9],x=l[2],g=l[6],m=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-x)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+x)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,b=(d+1)/2,S=(m+1)/2,M=(h+f)/4,y=(u+x)/4,T=(p+g)/4;return w>b&&w>S?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=M/i,r=y/i):b>S?b<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(b),i=M/s,r=T/s):S<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(S),i=y/r,s=T/r),this.set(i,s,r,e),this}let _=Math.sqrt((g-p)*(g-p)+(u-x)*(u-x)+(f-h)*(f-h));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(u-x)/_,this.z=(f-h)/_,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=de(this.x,t.x,e.x),this.y=de(this.y,t.y,e.y),this.z=de(this.z,t.z,e.z),this.w=de(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=de(this.x,t,e),this.y=de(this.y,t,e),this.z=de(this.z,t,e),this.w=de(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(de(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ll=class extends Ei{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:qn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new qe(0,0,t,e),this.scissorTest=!1,this.viewport=new qe(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Zn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:qn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new jr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},ai=class extends Ll{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},jo=class extends Zn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Gi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Nl=class extends Zn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Cn,this.minFilter=Cn,this.wrapR=Gi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var pe=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,u,f,d,p,x,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,f,d,p,x,g)}set(t,e,i,s,r,o,a,l,c,h,u,f,d,p,x,g){let m=this.elements;return m[0]=t,m[4]=e,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=h,m[10]=u,m[14]=f,m[3]=d,m[7]=p,m[11]=x,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Dr.setFromMatrixColumn(t,0).length(),r=1/Dr.setFromMatrixColumn(t,1).length(),o=1/Dr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,d=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=d+p*c,e[5]=f-x*c,e[9]=-a*l,e[2]=x-f*c,e[6]=p+d*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,d=l*u,p=c*h,x=c*u;e[0]=f+x*a,e[4]=p*a-d,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=d*a-p,e[6]=x+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,d=l*u,p=c*h,x=c*u;e[0]=f-x*a,e[4]=-o*u,e[8]=p+d*a,e[1]=d+p*a,e[5]=o*h,e[9]=x-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,d=o*u,p=a*h,x=a*u;e[0]=l*h,e[4]=p*c-d,e[8]=f*c+x,e[1]=l*u,e[5]=x*c+f,e[9]=d*c-p,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,d=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=x-f*u,e[8]=p*u+d,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=d*u+p,e[10]=f-x*u}else if(t.order==="XZY"){let f=o*l,d=o*c,p=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+x,e[5]=o*h,e[9]=d*u-p,e[2]=p*u-d,e[6]=a*h,e[10]=x*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(xx,t,yx)}lookAt(t,e,i){let s=this.elements;return ni.subVectors(t,e),ni.lengthSq()===0&&(ni.z=1),ni.normalize(),Rs.crossVectors(i,ni),Rs.lengthSq()===0&&(Math.abs(i.z)===1?ni.x+=1e-4:ni.z+=1e-4,ni.normalize(),Rs.crossVectors(i,ni)),Rs.normalize(),Ja.crossVectors(ni,Rs),s[0]=Rs.x,s[4]=Ja.x,s[8]=ni.x,s[1]=Rs.y,s[5]=Ja.y,s[9]=ni.y,s[2]=Rs.z,s[6]=Ja.z,s[10]=ni.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],d=i[13],p=i[2],x=i[6],g=i[10],m=i[14],_=i[3],w=i[7],b=i[11],S=i[15],M=s[0],y=s[4],T=s[8],I=s[12],P=s[1],R=s[5],F=s[9],z=s[13],U=s[2],G=s[6],q=s[10],H=s[14],lt=s[3],J=s[7],Q=s[11],it=s[15];return r[0]=o*M+a*P+l*U+c*lt,r[4]=o*y+a*R+l*G+c*J,r[8]=o*T+a*F+l*q+c*Q,r[12]=o*I+a*z+l*H+c*it,r[1]=h*M+u*P+f*U+d*lt,r[5]=h*y+u*R+f*G+d*J,r[9]=h*T+u*F+f*q+d*Q,r[13]=h*I+u*z+f*H+d*it,r[2]=p*M+x*P+g*U+m*lt,r[6]=p*y+x*R+g*G+m*J,r[10]=p*T+x*F+g*q+m*Q,r[14]=p*I+x*z+g*H+m*it,r[3]=_*M+w*P+b*U+S*lt,r[7]=_*y+w*R+b*G+S*J,r[11]=_*T+w*F+b*q+S*Q,r[15]=_*I+w*z+b*H+S*it,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],d=t[14],p=t[3],x=t[7],g=t[11],m=t[15],_=l*d-c*f,w=a*d-c*u,b=a*f-l*u,S=o*d-c*h,M=o*f-l*h,y=o*u-a*h;return e*(x*_-g*w+m*b)-i*(p*_-g*S+m*M)+s*(p*w-x*S+m*y)-r*(p*b-x*M+g*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],d=t[11],p=t[12],x=t[13],g=t[14],m=t[15],_=e*a-i*o,w=e*l-s*o,b=e*c-r*o,S=i*l-s*a,M=i*c-r*a,y=s*c-r*l,T=h*x-u*p,I=h*g-f*p,P=h*m-d*p,R=u*g-f*x,F=u*m-d*x,z=f*m-d*g,U=_*z-w*F+b*R+S*P-M*I+y*T;if(U===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let G=1/U;return t[0]=(a*z-l*F+c*R)*G,t[1]=(s*F-i*z-r*R)*G,t[2]=(x*y-g*M+m*S)*G,t[3]=(f*M-u*y-d*S)*G,t[4]=(l*P-o*z-c*I)*G,t[5]=(e*z-s*P+r*I)*G,t[6]=(g*b-p*y-m*w)*G,t[7]=(h*y-f*b+d*w)*G,t[8]=(o*F-a*P+c*T)*G,t[9]=(i*P-e*F-r*T)*G,t[10]=(p*M-x*b+m*_)*G,t[11]=(u*b-h*M-d*_)*G,t[12]=(a*I-o*R-l*T)*G,t[13]=(e*R-i*I+s*T)*G,t[14]=(x*w-p*S-g*_)*G,t[15]=(h*S-u*w+f*_)*G,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,d=r*h,p=r*u,x=o*h,g=o*u,m=a*u,_=l*c,w=l*h,b=l*u,S=i.x,M=i.y,y=i.z;return s[0]=(1-(x+m))*S,s[1]=(d+b)*S,s[2]=(p-w)*S,s[3]=0,s[4]=(d-b)*M,s[5]=(1-(f+m))*M,s[6]=(g+_)*M,s[7]=0,s[8]=(p+w)*y,s[9]=(g-_)*y,s[10]=(1-(f+x))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Dr.set(s[0],s[1],s[2]).length(),a=Dr.set(s[4],s[5],s[6]).length(),l=Dr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),wi.copy(this);let c=1/o,h=1/a,u=1/l;return wi.elements[0]*=c,wi.elements[1]*=c,wi.elements[2]*=c,wi.elements[4]*=h,wi.elements[5]*=h,wi.elements[6]*=h,wi.elements[8]*=u,wi.elements[9]*=u,wi.elements[10]*=u,e.setFromRotationMatrix(wi),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=gi,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),f=(e+t)/(e-t),d=(i+s)/(i-s),p,x;if(l)p=r/(o-r),x=o*r/(o-r);else if(a===gi)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Zr)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=gi,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),f=-(e+t)/(e-t),d=-(i+s)/(i-s),p,x;if(l)p=1/(o-r),x=o/(o-r);else if(a===gi)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===Zr)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Dr=new W,wi=new pe,xx=new W(0,0,0),yx=new W(1,1,1),Rs=new W,Ja=new W,ni=new W,Ud=new pe,Od=new oi,cs=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],d=s[10];switch(e){case"XYZ":this._y=Math.asin(de(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-de(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(de(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-de(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(de(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-de(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,d),this._y=0);break;default:qt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Ud.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Ud,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Od.setFromEuler(this),this.setFromQuaternion(Od,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};cs.DEFAULT_ORDER="XYZ";var Qr=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},vx=0,Fd=new W,Ur=new oi,ns=new pe,Ka=new W,Bo=new W,bx=new W,Sx=new oi,Bd=new W(1,0,0),kd=new W(0,1,0),zd=new W(0,0,1),Vd={type:"added"},Mx={type:"removed"},Or={type:"childadded",child:null},qh={type:"childremoved",child:null},In=class n extends Ei{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:vx++}),this.uuid=co(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new W,e=new cs,i=new oi,s=new W(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new pe},normalMatrix:{value:new ee}}),this.matrix=new pe,this.matrixWorld=new pe,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Qr,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ur.setFromAxisAngle(t,e),this.quaternion.multiply(Ur),this}rotateOnWorldAxis(t,e){return Ur.setFromAxisAngle(t,e),this.quaternion.premultiply(Ur),this}rotateX(t){return this.rotateOnAxis(Bd,t)}rotateY(t){return this.rotateOnAxis(kd,t)}rotateZ(t){return this.rotateOnAxis(zd,t)}translateOnAxis(t,e){return Fd.copy(t).applyQuaternion(this.quaternion),this.position.add(Fd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Bd,t)}translateY(t){return this.translateOnAxis(kd,t)}translateZ(t){return this.translateOnAxis(zd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ns.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Ka.copy(t):Ka.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Bo.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ns.lookAt(Bo,Ka,this.up):ns.lookAt(Ka,Bo,this.up),this.quaternion.setFromRotationMatrix(ns),s&&(ns.extractRotation(s.matrixWorld),Ur.setFromRotationMatrix(ns),this.quaternion.premultiply(Ur.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(jt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Vd),Or.child=t,this.dispatchEvent(Or),Or.child=null):jt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(Mx),qh.child=t,this.dispatchEvent(qh),qh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ns.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ns.multiply(t.parent.matrixWorld)),t.applyMatrix4(ns),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Vd),Or.child=t,this.dispatchEvent(Or),Or.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bo,t,bx),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Bo,Sx,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),d=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};In.DEFAULT_UP=new W(0,1,0);In.DEFAULT_MATRIX_AUTO_UPDATE=!0;In.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Fn=class extends In{constructor(){super(),this.isGroup=!0,this.type="Group"}},wx={type:"move"},to=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Fn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Fn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new W,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new W),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Fn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new W,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new W,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let g=e.getJointPose(x,i),m=this._getHandJoint(c,x);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),d=.02,p=.005;c.inputState.pinching&&f>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(wx)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Fn;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},$p={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Ps={h:0,s:0,l:0},ja={h:0,s:0,l:0};function $h(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Qt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=si){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,_e.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=_e.workingColorSpace){return this.r=t,this.g=e,this.b=i,_e.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=_e.workingColorSpace){if(t=Wu(t,1),e=de(e,0,1),i=de(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=$h(o,r,t+1/3),this.g=$h(o,r,t),this.b=$h(o,r,t-1/3)}return _e.colorSpaceToWorking(this,s),this}setStyle(t,e=si){function i(r){r!==void 0&&parseFloat(r)<1&&qt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:qt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);qt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=si){let i=$p[t.toLowerCase()];return i!==void 0?this.setHex(i,e):qt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=as(t.r),this.g=as(t.g),this.b=as(t.b),this}copyLinearToSRGB(t){return this.r=$r(t.r),this.g=$r(t.g),this.b=$r(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=si){return _e.workingToColorSpace(On.copy(this),t),Math.round(de(On.r*255,0,255))*65536+Math.round(de(On.g*255,0,255))*256+Math.round(de(On.b*255,0,255))}getHexString(t=si){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=_e.workingColorSpace){_e.workingToColorSpace(On.copy(this),e);let i=On.r,s=On.g,r=On.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=_e.workingColorSpace){return _e.workingToColorSpace(On.copy(this),e),t.r=On.r,t.g=On.g,t.b=On.b,t}getStyle(t=si){_e.workingToColorSpace(On.copy(this),t);let e=On.r,i=On.g,s=On.b;return t!==si?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Ps),this.setHSL(Ps.h+t,Ps.s+e,Ps.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Ps),t.getHSL(ja);let i=$o(Ps.h,ja.h,e),s=$o(Ps.s,ja.s,e),r=$o(Ps.l,ja.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},On=new Qt;Qt.NAMES=$p;var Qo=class extends In{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new cs,this.environmentIntensity=1,this.environmentRotation=new cs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Ai=new W,is=new W,Yh=new W,ss=new W,Fr=new W,Br=new W,Gd=new W,Zh=new W,Jh=new W,Kh=new W,jh=new qe,Qh=new qe,tu=new qe,Ds=class n{constructor(t=new W,e=new W,i=new W){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Ai.subVectors(t,e),s.cross(Ai);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Ai.subVectors(s,e),is.subVectors(i,e),Yh.subVectors(t,e);let o=Ai.dot(Ai),a=Ai.dot(is),l=Ai.dot(Yh),c=is.dot(is),h=is.dot(Yh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,d=(c*l-a*h)*f,p=(o*h-a*l)*f;return r.set(1-d-p,p,d)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,ss)===null?!1:ss.x>=0&&ss.y>=0&&ss.x+ss.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,ss)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ss.x),l.addScaledVector(o,ss.y),l.addScaledVector(a,ss.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return jh.setScalar(0),Qh.setScalar(0),tu.setScalar(0),jh.fromBufferAttribute(t,e),Qh.fromBufferAttribute(t,i),tu.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(jh,r.x),o.addScaledVector(Qh,r.y),o.addScaledVector(tu,r.z),o}static isFrontFacing(t,e,i,s){return Ai.subVectors(i,e),is.subVectors(t,e),Ai.cross(is).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Ai.subVectors(this.c,this.b),is.subVectors(this.a,this.b),Ai.cross(is).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Fr.subVectors(s,i),Br.subVectors(r,i),Zh.subVectors(t,i);let l=Fr.dot(Zh),c=Br.dot(Zh);if(l<=0&&c<=0)return e.copy(i);Jh.subVectors(t,s);let h=Fr.dot(Jh),u=Br.dot(Jh);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(Fr,o);Kh.subVectors(t,r);let d=Fr.dot(Kh),p=Br.dot(Kh);if(p>=0&&d<=p)return e.copy(r);let x=d*c-l*p;if(x<=0&&c>=0&&p<=0)return a=c/(c-p),e.copy(i).addScaledVector(Br,a);let g=h*p-d*u;if(g<=0&&u-h>=0&&d-p>=0)return Gd.subVectors(r,s),a=(u-h)/(u-h+(d-p)),e.copy(s).addScaledVector(Gd,a);let m=1/(g+x+f);return o=x*m,a=f*m,e.copy(i).addScaledVector(Fr,o).addScaledVector(Br,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Hi=class{constructor(t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Ti.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Ti.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Ti.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Ti):Ti.fromBufferAttribute(r,o),Ti.applyMatrix4(t.matrixWorld),this.expandByPoint(Ti);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Qa.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Qa.copy(i.boundingBox)),Qa.applyMatrix4(t.matrixWorld),this.union(Qa)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Ti),Ti.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(ko),tl.subVectors(this.max,ko),kr.subVectors(t.a,ko),zr.subVectors(t.b,ko),Vr.subVectors(t.c,ko),Is.subVectors(zr,kr),Ls.subVectors(Vr,zr),er.subVectors(kr,Vr);let e=[0,-Is.z,Is.y,0,-Ls.z,Ls.y,0,-er.z,er.y,Is.z,0,-Is.x,Ls.z,0,-Ls.x,er.z,0,-er.x,-Is.y,Is.x,0,-Ls.y,Ls.x,0,-er.y,er.x,0];return!eu(e,kr,zr,Vr,tl)||(e=[1,0,0,0,1,0,0,0,1],!eu(e,kr,zr,Vr,tl))?!1:(el.crossVectors(Is,Ls),e=[el.x,el.y,el.z],eu(e,kr,zr,Vr,tl))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Ti).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Ti).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(rs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),rs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),rs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),rs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),rs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),rs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),rs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),rs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(rs),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},rs=[new W,new W,new W,new W,new W,new W,new W,new W],Ti=new W,Qa=new Hi,kr=new W,zr=new W,Vr=new W,Is=new W,Ls=new W,er=new W,ko=new W,tl=new W,el=new W,nr=new W;function eu(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){nr.fromArray(n,r);let a=s.x*Math.abs(nr.x)+s.y*Math.abs(nr.y)+s.z*Math.abs(nr.z),l=t.dot(nr),c=e.dot(nr),h=i.dot(nr);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var fn=new W,nl=new Yt,Ax=0,sn=class extends Ei{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ax++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=zp,this.updateRanges=[],this.gpuType=_i,this.version=0,this._normalizationScale=t!==void 0?qu(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)nl.fromBufferAttribute(this,e),nl.applyMatrix3(t),this.setXY(e,nl.x,nl.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix3(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyMatrix4(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.applyNormalMatrix(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)fn.fromBufferAttribute(this,e),fn.transformDirection(t),this.setXYZ(e,fn.x,fn.y,fn.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Xp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):qp(t,this.array)}};var ta=class extends sn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var ea=class extends sn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Qe=class extends sn{constructor(t,e,i){super(new Float32Array(t),e,i)}},Tx=new Hi,zo=new W,nu=new W,hs=class{constructor(t=new W,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):Tx.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;zo.subVectors(t,this.center);let e=zo.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(zo,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(nu.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(zo.copy(t.center).add(nu)),this.expandByPoint(zo.copy(t.center).sub(nu))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},Ex=0,mi=new pe,iu=new In,Gr=new W,ii=new Hi,Vo=new Hi,En=new W,gn=class n extends Ei{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Ex++}),this.uuid=co(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(j_(t)?ea:ta)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ee().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return mi.makeRotationFromQuaternion(t),this.applyMatrix4(mi),this}rotateX(t){return mi.makeRotationX(t),this.applyMatrix4(mi),this}rotateY(t){return mi.makeRotationY(t),this.applyMatrix4(mi),this}rotateZ(t){return mi.makeRotationZ(t),this.applyMatrix4(mi),this}translate(t,e,i){return mi.makeTranslation(t,e,i),this.applyMatrix4(mi),this}scale(t,e,i){return mi.makeScale(t,e,i),this.applyMatrix4(mi),this}lookAt(t){return iu.lookAt(t),iu.updateMatrix(),this.applyMatrix4(iu.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Gr).negate(),this.translate(Gr.x,Gr.y,Gr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Qe(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&qt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Hi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new W(-1/0,-1/0,-1/0),new W(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];ii.setFromBufferAttribute(r),this.morphTargetsRelative?(En.addVectors(this.boundingBox.min,ii.min),this.boundingBox.expandByPoint(En),En.addVectors(this.boundingBox.max,ii.max),this.boundingBox.expandByPoint(En)):(this.boundingBox.expandByPoint(ii.min),this.boundingBox.expandByPoint(ii.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&jt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new hs);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){jt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new W,1/0);return}if(t){let i=this.boundingSphere.center;if(ii.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Vo.setFromBufferAttribute(a),this.morphTargetsRelative?(En.addVectors(ii.min,Vo.min),ii.expandByPoint(En),En.addVectors(ii.max,Vo.max),ii.expandByPoint(En)):(ii.expandByPoint(Vo.min),ii.expandByPoint(Vo.max))}ii.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)En.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(En));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)En.fromBufferAttribute(a,c),l&&(Gr.fromBufferAttribute(t,c),En.add(Gr)),s=Math.max(s,i.distanceToSquared(En))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&jt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){jt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new sn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let I=0;I<i.count;I++)a[I]=new W,l[I]=new W;let h=new W,u=new W,f=new W,d=new Yt,p=new Yt,x=new Yt,g=new W,m=new W;function _(I,P,R){c[I]=c[P]=c[R]=1,h.fromBufferAttribute(i,I),u.fromBufferAttribute(i,P),f.fromBufferAttribute(i,R),d.fromBufferAttribute(r,I),p.fromBufferAttribute(r,P),x.fromBufferAttribute(r,R),u.sub(h),f.sub(h),p.sub(d),x.sub(d);let F=1/(p.x*x.y-x.x*p.y);isFinite(F)&&(g.copy(u).multiplyScalar(x.y).addScaledVector(f,-p.y).multiplyScalar(F),m.copy(f).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(F),a[I].add(g),a[P].add(g),a[R].add(g),l[I].add(m),l[P].add(m),l[R].add(m))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let I=0,P=w.length;I<P;++I){let R=w[I],F=R.start,z=R.count;for(let U=F,G=F+z;U<G;U+=3)_(t.getX(U+0),t.getX(U+1),t.getX(U+2))}let b=new W,S=new W,M=new W,y=new W;function T(I){M.fromBufferAttribute(s,I),y.copy(M);let P=a[I];b.copy(P),b.sub(M.multiplyScalar(M.dot(P))).normalize(),S.crossVectors(y,P);let F=S.dot(l[I])<0?-1:1;o.setXYZW(I,b.x,b.y,b.z,F)}for(let I=0,P=i.count;I<P;++I)c[I]&&T(I);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new sn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,d=i.count;f<d;f++)i.setXYZ(f,0,0,0);let s=new W,r=new W,o=new W,a=new W,l=new W,c=new W,h=new W,u=new W;if(t)for(let f=0,d=t.count;f<d;f+=3){let p=t.getX(f+0),x=t.getX(f+1),g=t.getX(f+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,g),a.add(h),l.add(h),c.add(h),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let f=0,d=e.count;f<d;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)En.fromBufferAttribute(t,e),En.normalize(),t.setXYZ(e,En.x,En.y,En.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),d=0,p=0;for(let x=0,g=l.length;x<g;x++){a.isInterleavedBufferAttribute?d=l[x]*a.data.stride+a.offset:d=l[x]*h;for(let m=0;m<h;m++)f[p++]=c[d++]}return new sn(f,h,u)}if(this.index===null)return qt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],d=t(f,i);l.push(d)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let d=c[u];h.push(d.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,d=u.length;f<d;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var su=new W,Cx=new W,Rx=new ee,ri=class{constructor(t=new W(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=su.subVectors(i,e).cross(Cx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(su),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||Rx.getNormalMatrix(t),s=this.coplanarPoint(su).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},Px=0,us=class extends Ei{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Px++}),this.uuid=co(),this.name="",this.type="Material",this.blending=oo,this.side=Hs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=bu,this.blendDst=Su,this.blendEquation=lr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Qt(0,0,0),this.blendAlpha=0,this.depthFunc=Yr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Dp,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=vl,this.stencilZFail=vl,this.stencilZPass=vl,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){qt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){qt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Qt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new ri().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var os=new W,ru=new W,il=new W,sl=new W,Us=class{constructor(t=new W,e=new W(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,os)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=os.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(os.copy(this.origin).addScaledVector(this.direction,e),os.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){ru.copy(t).add(e).multiplyScalar(.5),il.copy(e).sub(t).normalize(),sl.copy(this.origin).sub(ru);let r=t.distanceTo(e)*.5,o=-this.direction.dot(il),a=sl.dot(this.direction),l=-sl.dot(il),c=sl.lengthSq(),h=Math.abs(1-o*o),u,f,d,p;if(h>0)if(u=o*l-a,f=o*a-l,p=r*h,u>=0)if(f>=-p)if(f<=p){let x=1/h;u*=x,f*=x,d=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;else f<=-p?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c):f<=p?(u=0,f=Math.min(Math.max(-r,-l),r),d=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),d=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),d=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(ru).addScaledVector(il,f),d}intersectSphere(t,e){if(t.radius<0)return null;os.subVectors(t.center,this.origin);let i=os.dot(this.direction),s=os.dot(os)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,os)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,d=t.z-o.z,p=e.x-o.x,x=e.y-o.y,g=e.z-o.z,m=i.x-o.x,_=i.y-o.y,w=i.z-o.z,b=Math.abs(l),S=Math.abs(c),M=Math.abs(h),y,T,I,P,R,F,z,U,G,q,H,lt;if(b>=S&&b>=M?(I=l,F=u,G=p,lt=m,l>=0?(y=c,T=h,P=f,R=d,z=x,U=g,q=_,H=w):(y=h,T=c,P=d,R=f,z=g,U=x,q=w,H=_)):S>=M?(I=c,F=f,G=x,lt=_,c>=0?(y=h,T=l,P=d,R=u,z=g,U=p,q=w,H=m):(y=l,T=h,P=u,R=d,z=p,U=g,q=m,H=w)):(I=h,F=d,G=g,lt=w,h>=0?(y=l,T=c,P=u,R=f,z=p,U=x,q=m,H=_):(y=c,T=l,P=f,R=u,z=x,U=p,q=_,H=m)),I===0)return null;let J=y/I,Q=T/I,it=1/I,dt=P-J*F,ft=R-Q*F,tt=z-J*G,ut=U-Q*G,gt=q-J*lt,St=H-Q*lt,Mt=gt*ut-St*tt,Ht=dt*St-ft*gt,se=tt*ft-ut*dt;if(s){if(Mt<0||Ht<0||se<0)return null}else if((Mt<0||Ht<0||se<0)&&(Mt>0||Ht>0||se>0))return null;let Vt=Mt+Ht+se;if(Vt===0)return null;let he=it*(Mt*F+Ht*G+se*lt);return(Vt>0?he<0:he>0)?null:this.at(he/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},rr=class extends us{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new cs,this.combine=Ql,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Hd=new pe,ir=new Us,rl=new hs,Wd=new W,ol=new W,al=new W,ll=new W,ou=new W,cl=new W,Xd=new W,hl=new W,Ln=class extends In{constructor(t=new gn,e=new rr){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){cl.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(ou.fromBufferAttribute(u,t),o?cl.addScaledVector(ou,h):cl.addScaledVector(ou.sub(e),h))}e.add(cl)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),rl.copy(i.boundingSphere),rl.applyMatrix4(r),ir.copy(t.ray).recast(t.near),!(rl.containsPoint(ir.origin)===!1&&(ir.intersectSphere(rl,Wd)===null||ir.origin.distanceToSquared(Wd)>(t.far-t.near)**2))&&(Hd.copy(r).invert(),ir.copy(t.ray).applyMatrix4(Hd),!(i.boundingBox!==null&&ir.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,ir)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=f.length;p<x;p++){let g=f[p],m=o[g.materialIndex],_=Math.max(g.start,d.start),w=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let b=_,S=w;b<S;b+=3){let M=a.getX(b),y=a.getX(b+1),T=a.getX(b+2);s=ul(this,m,t,i,c,h,u,M,y,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,d.start),x=Math.min(a.count,d.start+d.count);for(let g=p,m=x;g<m;g+=3){let _=a.getX(g),w=a.getX(g+1),b=a.getX(g+2);s=ul(this,o,t,i,c,h,u,_,w,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,x=f.length;p<x;p++){let g=f[p],m=o[g.materialIndex],_=Math.max(g.start,d.start),w=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let b=_,S=w;b<S;b+=3){let M=b,y=b+1,T=b+2;s=ul(this,m,t,i,c,h,u,M,y,T),s&&(s.faceIndex=Math.floor(b/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,d.start),x=Math.min(l.count,d.start+d.count);for(let g=p,m=x;g<m;g+=3){let _=g,w=g+1,b=g+2;s=ul(this,o,t,i,c,h,u,_,w,b),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function Ix(n,t,e,i,s,r,o,a){let l;if(t.side===$n?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Hs,a),l===null)return null;hl.copy(a),hl.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(hl);return c<e.near||c>e.far?null:{distance:c,point:hl.clone(),object:n}}function ul(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ol),n.getVertexPosition(l,al),n.getVertexPosition(c,ll);let h=Ix(n,t,e,i,ol,al,ll,Xd);if(h){let u=new W;Ds.getBarycoord(Xd,ol,al,ll,u),s&&(h.uv=Ds.getInterpolatedAttribute(s,a,l,c,u,new Yt)),r&&(h.uv1=Ds.getInterpolatedAttribute(r,a,l,c,u,new Yt)),o&&(h.normal=Ds.getInterpolatedAttribute(o,a,l,c,u,new W),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new W,materialIndex:0};Ds.getNormal(ol,al,ll,f.normal),h.face=f,h.barycoord=u}return h}var na=class extends Zn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Cn,h=Cn,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ia=class extends sn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Hr=new pe,qd=new pe,fl=[],$d=new Hi,Lx=new pe,Go=new Ln,Ho=new hs,li=class extends Ln{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new ia(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,Lx)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Hi),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Hr),$d.copy(t.boundingBox).applyMatrix4(Hr),this.boundingBox.union($d)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new hs),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Hr),Ho.copy(t.boundingSphere).applyMatrix4(Hr),this.boundingSphere.union(Ho)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Go.geometry=this.geometry,Go.material=this.material,Go.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ho.copy(this.boundingSphere),Ho.applyMatrix4(i),t.ray.intersectsSphere(Ho)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Hr),qd.multiplyMatrices(i,Hr),Go.matrixWorld=qd,Go.raycast(t,fl);for(let o=0,a=fl.length;o<a;o++){let l=fl[o];l.instanceId=r,l.object=this,e.push(l)}fl.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new ia(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new na(new Float32Array(s*this.count),s,this.count,oc,_i));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},sr=new hs,Nx=new Yt(.5,.5),dl=new W,Os=class{constructor(t=new ri,e=new ri,i=new ri,s=new ri,r=new ri,o=new ri){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=gi,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],d=r[7],p=r[8],x=r[9],g=r[10],m=r[11],_=r[12],w=r[13],b=r[14],S=r[15];if(s[0].setComponents(c-o,d-h,m-p,S-_).normalize(),s[1].setComponents(c+o,d+h,m+p,S+_).normalize(),s[2].setComponents(c+a,d+u,m+x,S+w).normalize(),s[3].setComponents(c-a,d-u,m-x,S-w).normalize(),i)s[4].setComponents(l,f,g,b).normalize(),s[5].setComponents(c-l,d-f,m-g,S-b).normalize();else if(s[4].setComponents(c-l,d-f,m-g,S-b).normalize(),e===gi)s[5].setComponents(c+l,d+f,m+g,S+b).normalize();else if(e===Zr)s[5].setComponents(l,f,g,b).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),sr.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),sr.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(sr)}intersectsSprite(t){sr.center.set(0,0,0);let e=Nx.distanceTo(t.center);return sr.radius=.7071067811865476+e,sr.applyMatrix4(t.matrixWorld),this.intersectsSphere(sr)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(dl.x=s.normal.x>0?t.max.x:t.min.x,dl.y=s.normal.y>0?t.max.y:t.min.y,dl.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(dl)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Yd=new pe,Dl=class n{constructor(){this.coordinateSystem=gi,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Yd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Os),i[s].setFromProjectionMatrix(Yd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Os),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Fs=class extends us{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Qt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Ul=new W,Ol=new W,Zd=new pe,Wo=new Us,pl=new hs,au=new W,Jd=new W,Fl=class extends In{constructor(t=new gn,e=new Fs){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Ul.fromBufferAttribute(e,s-1),Ol.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Ul.distanceTo(Ol);t.setAttribute("lineDistance",new Qe(i,1))}else qt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),pl.copy(i.boundingSphere),pl.applyMatrix4(s),pl.radius+=r,t.ray.intersectsSphere(pl)===!1)return;Zd.copy(s).invert(),Wo.copy(t.ray).applyMatrix4(Zd);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,f=i.attributes.position;if(h!==null){let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=d,g=p-1;x<g;x+=c){let m=h.getX(x),_=h.getX(x+1),w=ml(this,t,Wo,l,m,_,x);w&&e.push(w)}if(this.isLineLoop){let x=h.getX(p-1),g=h.getX(d),m=ml(this,t,Wo,l,x,g,p-1);m&&e.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(f.count,o.start+o.count);for(let x=d,g=p-1;x<g;x+=c){let m=ml(this,t,Wo,l,x,x+1,x);m&&e.push(m)}if(this.isLineLoop){let x=ml(this,t,Wo,l,p-1,d,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ml(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Ul.fromBufferAttribute(a,s),Ol.fromBufferAttribute(a,r),e.distanceSqToSegment(Ul,Ol,au,Jd)>i)return;au.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(au);if(!(c<t.near||c>t.far))return{distance:c,point:Jd.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Kd=new W,jd=new W,or=class extends Fl{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[];for(let s=0,r=e.count;s<r;s+=2)Kd.fromBufferAttribute(e,s),jd.fromBufferAttribute(e,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+Kd.distanceTo(jd);t.setAttribute("lineDistance",new Qe(i,1))}else qt("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var sa=class extends Zn{constructor(t=[],e=cr,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var fs=class extends Zn{constructor(t,e,i=Ci,s,r,o,a=Cn,l=Cn,c,h=ls,u=1){if(h!==ls&&h!==ms)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new jr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ra=class extends fs{constructor(t,e=Ci,i=cr,s,r,o=Cn,a=Cn,l,c=ls){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},oa=class extends Zn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},eo=class n extends gn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,d=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Qe(c,3)),this.setAttribute("normal",new Qe(h,3)),this.setAttribute("uv",new Qe(u,2));function p(x,g,m,_,w,b,S,M,y,T,I){let P=b/y,R=S/T,F=b/2,z=S/2,U=M/2,G=y+1,q=T+1,H=0,lt=0,J=new W;for(let Q=0;Q<q;Q++){let it=Q*R-z;for(let dt=0;dt<G;dt++){let ft=dt*P-F;J[x]=ft*_,J[g]=it*w,J[m]=U,c.push(J.x,J.y,J.z),J[x]=0,J[g]=0,J[m]=M>0?1:-1,h.push(J.x,J.y,J.z),u.push(dt/y),u.push(1-Q/T),H+=1}}for(let Q=0;Q<T;Q++)for(let it=0;it<y;it++){let dt=f+it+G*Q,ft=f+it+G*(Q+1),tt=f+(it+1)+G*(Q+1),ut=f+(it+1)+G*Q;l.push(dt,ft,ut),l.push(ft,tt,ut),lt+=6}a.addGroup(d,lt,I),d+=lt,f+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Wi=class n extends gn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],d=[],p=0,x=[],g=i/2,m=0;_(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Qe(u,3)),this.setAttribute("normal",new Qe(f,3)),this.setAttribute("uv",new Qe(d,2));function _(){let b=new W,S=new W,M=0,y=(e-t)/i;for(let T=0;T<=r;T++){let I=[],P=T/r,R=P*(e-t)+t;for(let F=0;F<=s;F++){let z=F/s,U=z*l+a,G=Math.sin(U),q=Math.cos(U);S.x=R*G,S.y=-P*i+g,S.z=R*q,u.push(S.x,S.y,S.z),b.set(G,y,q).normalize(),f.push(b.x,b.y,b.z),d.push(z,1-P),I.push(p++)}x.push(I)}for(let T=0;T<s;T++)for(let I=0;I<r;I++){let P=x[I][T],R=x[I+1][T],F=x[I+1][T+1],z=x[I][T+1];(t>0||I!==0)&&(h.push(P,R,z),M+=3),(e>0||I!==r-1)&&(h.push(R,F,z),M+=3)}c.addGroup(m,M,0),m+=M}function w(b){let S=p,M=new Yt,y=new W,T=0,I=b===!0?t:e,P=b===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,g*P,0),f.push(0,P,0),d.push(.5,.5),p++;let R=p;for(let F=0;F<=s;F++){let U=F/s*l+a,G=Math.cos(U),q=Math.sin(U);y.x=I*q,y.y=g*P,y.z=I*G,u.push(y.x,y.y,y.z),f.push(0,P,0),M.x=G*.5+.5,M.y=q*.5*P+.5,d.push(M.x,M.y),p++}for(let F=0;F<s;F++){let z=S+F,U=R+F;b===!0?h.push(U,U+1,z):h.push(U+1,U,z),T+=3}c.addGroup(m,T,b===!0?1:2),m+=T}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},aa=class n extends Wi{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var la=class n extends gn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,d=[],p=[],x=[],g=[];for(let m=0;m<h;m++){let _=m*f-o;for(let w=0;w<c;w++){let b=w*u-r;p.push(b,-_,0),x.push(0,0,1),g.push(w/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let _=0;_<a;_++){let w=_+c*m,b=_+c*(m+1),S=_+1+c*(m+1),M=_+1+c*m;d.push(w,b,M),d.push(b,S,M)}this.setIndex(d),this.setAttribute("position",new Qe(p,3)),this.setAttribute("normal",new Qe(x,3)),this.setAttribute("uv",new Qe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var no=class n extends gn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new W,f=new W,d=[],p=[],x=[],g=[];for(let m=0;m<=i;m++){let _=[],w=m/i,b=o+w*a,S=t*Math.cos(b),M=Math.sqrt(t*t-S*S),y=0;m===0&&o===0?y=.5/e:m===i&&l===Math.PI&&(y=-.5/e);for(let T=0;T<=e;T++){let I=T/e,P=s+I*r;u.x=-M*Math.cos(P),u.y=S,u.z=M*Math.sin(P),p.push(u.x,u.y,u.z),f.copy(u).normalize(),x.push(f.x,f.y,f.z),g.push(I+y,1-w),_.push(c++)}h.push(_)}for(let m=0;m<i;m++)for(let _=0;_<e;_++){let w=h[m][_+1],b=h[m][_],S=h[m+1][_],M=h[m+1][_+1];(m!==0||o>0)&&d.push(w,b,M),(m!==i-1||l<Math.PI)&&d.push(b,S,M)}this.setIndex(d),this.setAttribute("position",new Qe(p,3)),this.setAttribute("normal",new Qe(x,3)),this.setAttribute("uv",new Qe(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};function ur(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Qd(s))s.isRenderTargetTexture?(qt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Qd(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function kn(n){let t={};for(let e=0;e<n.length;e++){let i=ur(n[e]);for(let s in i)t[s]=i[s]}return t}function Qd(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Dx(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Yu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:_e.workingColorSpace}var Yp={clone:ur,merge:kn},Ux=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Ox=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Xi=class extends us{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Ux,this.fragmentShader=Ox,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ur(t.uniforms),this.uniformsGroups=Dx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Qt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new W().fromArray(s.value);break;case"v4":this.uniforms[i].value=new qe().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ee().fromArray(s.value);break;case"m4":this.uniforms[i].value=new pe().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Bl=class extends Xi{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ds=class extends us{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new Qt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Qt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=zc,this.normalScale=new Yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new cs,this.combine=Ql,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},kl=class extends us{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Lp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},zl=class extends us{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Wr(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function gl(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Bs=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Vl=class extends Bs{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:hu,endingEnd:hu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case uu:r=t,a=2*e-i;break;case fu:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case uu:o=t,l=2*i-e;break;case fu:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,d=this._weightNext,p=(i-e)/(s-e),x=p*p,g=x*p,m=-f*g+2*f*x-f*p,_=(1+f)*g+(-1.5-2*f)*x+(-.5+f)*p+1,w=(-1-d)*g+(1.5+d)*x+.5*p,b=d*g-d*x;for(let S=0;S!==a;++S)r[S]=m*o[h+S]+_*o[c+S]+w*o[l+S]+b*o[u+S];return r}},Gl=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Hl=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Wl=class extends Bs{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-e)/(s-e),x=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*x+o[l+g]*p;return r}let f=a*2,d=t-1;for(let p=0;p!==a;++p){let x=o[c+p],g=o[l+p],m=d*f+p*2,_=u[m],w=u[m+1],b=t*f+p*2,S=h[b],M=h[b+1],y=Bx(i,e,_,S,s);r[p]=Zp(y,x,w,M,g)}return r}};function Zp(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Fx(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Bx(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Zp(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Fx(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var ci=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Wr(e,this.TimeBufferType),this.values=Wr(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Wr(t.times,Array),values:Wr(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),gl(t.settings)&&(i.settings={inTangents:Wr(t.settings.inTangents,Array),outTangents:Wr(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Hl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Gl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Vl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Wl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Yo:e=this.InterpolantFactoryMethodDiscrete;break;case Pl:e=this.InterpolantFactoryMethodLinear;break;case yl:e=this.InterpolantFactoryMethodSmooth;break;case cu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return qt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Yo;case this.InterpolantFactoryMethodLinear:return Pl;case this.InterpolantFactoryMethodSmooth:return yl;case this.InterpolantFactoryMethodBezier:return cu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;gl(this.settings)&&(tp(this.settings.inTangents,t),tp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;gl(this.settings)&&(ep(this.settings.inTangents,t),ep(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(jt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(jt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){jt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){jt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&Q_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){jt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===yl,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,f=u-i,d=u+i;for(let p=0;p!==i;++p){let x=e[u+p];if(x!==e[f+p]||x!==e[d+p]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,f=o*i;for(let d=0;d!==i;++d)e[f+d]=e[u+d]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,gl(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function tp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function ep(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}ci.prototype.ValueTypeName="";ci.prototype.TimeBufferType=Float32Array;ci.prototype.ValueBufferType=Float32Array;ci.prototype.DefaultInterpolation=Pl;var ks=class extends ci{constructor(t,e,i){super(t,e,i)}};ks.prototype.ValueTypeName="bool";ks.prototype.ValueBufferType=Array;ks.prototype.DefaultInterpolation=Yo;ks.prototype.InterpolantFactoryMethodLinear=void 0;ks.prototype.InterpolantFactoryMethodSmooth=void 0;var Xl=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};Xl.prototype.ValueTypeName="color";var ql=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};ql.prototype.ValueTypeName="number";var $l=class extends Bs{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)oi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ca=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new $l(this.times,this.values,this.getValueSize(),t)}};ca.prototype.ValueTypeName="quaternion";ca.prototype.InterpolantFactoryMethodSmooth=void 0;var zs=class extends ci{constructor(t,e,i){super(t,e,i)}};zs.prototype.ValueTypeName="string";zs.prototype.ValueBufferType=Array;zs.prototype.DefaultInterpolation=Yo;zs.prototype.InterpolantFactoryMethodLinear=void 0;zs.prototype.InterpolantFactoryMethodSmooth=void 0;var Yl=class extends ci{constructor(t,e,i,s){super(t,e,i,s)}};Yl.prototype.ValueTypeName="vector";var Zl=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let d=c[u],p=c[u+1];if(d.global&&(d.lastIndex=0),d.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Jp=new Zl,Jl=class{constructor(t){this.manager=t!==void 0?t:Jp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Jl.DEFAULT_MATERIAL_NAME="__DEFAULT";var ha=class extends In{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Qt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ua=class extends ha{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Qt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},lu=new pe,np=new W,ip=new W,Kl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Yt(512,512),this.mapType=Jn,this.map=null,this.mapPass=null,this.matrix=new pe,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Os,this._frameExtents=new Yt(1,1),this._viewportCount=1,this._viewports=[new qe(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;np.setFromMatrixPosition(t.matrixWorld),e.position.copy(np),ip.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(ip),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){lu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(lu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Zr||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(lu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},_l=new W,xl=new oi,Vi=new W,fa=class extends In{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new pe,this.projectionMatrix=new pe,this.projectionMatrixInverse=new pe,this.coordinateSystem=gi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(_l,xl,Vi),Vi.x===1&&Vi.y===1&&Vi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_l,xl,Vi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(_l,xl,Vi),Vi.x===1&&Vi.y===1&&Vi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(_l,xl,Vi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ns=new W,sp=new Yt,rp=new Yt,Xn=class extends fa{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Kr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(qo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Kr*2*Math.atan(Math.tan(qo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Ns.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z),Ns.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Ns.x,Ns.y).multiplyScalar(-t/Ns.z)}getViewSize(t,e){return this.getViewBounds(t,sp,rp),e.subVectors(rp,sp)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(qo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var da=class extends fa{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},du=class extends Kl{constructor(){super(new da(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},pa=class extends ha{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(In.DEFAULT_UP),this.updateMatrix(),this.target=new In,this.shadow=new du}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Xr=-90,qr=1,io=class extends In{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Xn(Xr,qr,t,e);s.layers=this.layers,this.add(s);let r=new Xn(Xr,qr,t,e);r.layers=this.layers,this.add(r);let o=new Xn(Xr,qr,t,e);o.layers=this.layers,this.add(o);let a=new Xn(Xr,qr,t,e);a.layers=this.layers,this.add(a);let l=new Xn(Xr,qr,t,e);l.layers=this.layers,this.add(l);let c=new Xn(Xr,qr,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===gi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Zr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),d=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,d),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},jl=class extends Xn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Zu="\\[\\]\\.:\\/",kx=new RegExp("["+Zu+"]","g"),Ju="[^"+Zu+"]",zx="[^"+Zu.replace("\\.","")+"]",Vx=/((?:WC+[\/:])*)/.source.replace("WC",Ju),Gx=/(WCOD+)?/.source.replace("WCOD",zx),Hx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Ju),Wx=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Ju),Xx=new RegExp("^"+Vx+Gx+Hx+Wx+"$"),qx=["material","materials","bones","map"],pu=class{constructor(t,e,i){let s=i||Ge.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},Ge=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(kx,"")}static parseTrackName(t){let e=Xx.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);qx.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){qt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){jt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){jt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){jt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){jt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){jt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){jt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;jt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){jt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Ge.Composite=pu;Ge.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Ge.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Ge.prototype.GetterByBindingType=[Ge.prototype._getValue_direct,Ge.prototype._getValue_array,Ge.prototype._getValue_arrayElement,Ge.prototype._getValue_toArray];Ge.prototype.SetterByBindingTypeAndVersioning=[[Ge.prototype._setValue_direct,Ge.prototype._setValue_direct_setNeedsUpdate,Ge.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_array,Ge.prototype._setValue_array_setNeedsUpdate,Ge.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_arrayElement,Ge.prototype._setValue_arrayElement_setNeedsUpdate,Ge.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Ge.prototype._setValue_fromArray,Ge.prototype._setValue_fromArray_setNeedsUpdate,Ge.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var hC=new Float32Array(1);var op=new pe,ma=class{constructor(t,e,i=0,s=1/0){this.ray=new Us(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Qr,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):jt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return op.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(op),this}intersectObject(t,e=!0,i=[]){return mu(t,this,i,e),i.sort(ap),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)mu(t[s],this,i,e);return i.sort(ap),i}};function ap(n,t){return n.distance-t.distance}function mu(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)mu(r[o],t,e,!0)}}var so=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=de(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(de(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var gu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var ga=class extends Ei{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Ku(n,t,e,i){let s=$x(i);switch(e){case Uu:return n*t;case oc:return n*t/s.components*s.byteLength;case ac:return n*t/s.components*s.byteLength;case Ws:return n*t*2/s.components*s.byteLength;case lc:return n*t*2/s.components*s.byteLength;case Ou:return n*t*3/s.components*s.byteLength;case Pi:return n*t*4/s.components*s.byteLength;case cc:return n*t*4/s.components*s.byteLength;case ya:case va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ba:case Sa:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case uc:case dc:return Math.max(n,16)*Math.max(t,8)/4;case hc:case fc:return Math.max(n,8)*Math.max(t,8)/2;case pc:case mc:case _c:case xc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case gc:case Ma:case yc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vc:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case bc:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case Sc:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Mc:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case wc:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Ac:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Tc:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Ec:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Cc:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Rc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Pc:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Ic:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Lc:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Nc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Dc:case Uc:case Oc:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Fc:case Bc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case wa:case kc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function $x(n){switch(n){case Jn:case Iu:return{byteLength:1,components:1};case lo:case Lu:case Ri:return{byteLength:2,components:1};case sc:case rc:return{byteLength:2,components:4};case Ci:case ic:case _i:return{byteLength:4,components:1};case Nu:case Du:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?qt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function xm(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Zx(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((d,p)=>d.start-p.start);let f=0;for(let d=1;d<u.length;d++){let p=u[f],x=u[d];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++f,u[f]=x)}u.length=f+1;for(let d=0,p=u.length;d<p;d++){let x=u[d];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Jx=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Kx=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,jx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Qx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ty=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ey=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,ny=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,iy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,sy=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,ry=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,oy=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ay=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ly=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,cy=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,hy=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,uy=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,fy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,dy=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,py=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,my=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,gy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,_y=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,xy=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,yy=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,vy=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,by=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Sy=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,My=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,wy=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Ay="gl_FragColor = linearToOutputTexel( gl_FragColor );",Ty=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Ey=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Cy=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Ry=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Py=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Iy=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Ly=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ny=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Dy=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Uy=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Oy=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Fy=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,By=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,ky=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,zy=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Vy=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Gy=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Hy=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Wy=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Xy=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,qy=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,$y=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Yy=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Zy=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Jy=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Ky=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,jy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Qy=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,tv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ev=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,nv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,iv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,sv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,rv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ov=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,av=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,lv=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,cv=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,hv=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,uv=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,fv=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,dv=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,pv=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,mv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,gv=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,_v=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,xv=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,yv=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,vv=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,bv=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,Sv=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,Mv=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,wv=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,Av=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,Tv=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,Ev=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Cv=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,Rv=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Pv=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Iv=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Lv=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Nv=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Dv=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Uv=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Ov=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Fv=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Bv=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,kv=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,zv=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Vv=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Gv=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Hv=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,Wv=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Xv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,qv=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,$v=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Yv=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Zv=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Jv=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Kv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jv=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Qv=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,tb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,nb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,ib=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,sb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,rb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ob=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ab=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,lb=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,cb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,hb=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,ub=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,fb=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,db=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,pb=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mb=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,gb=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,_b=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,xb=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,yb=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,vb=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,bb=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Sb=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Mb=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,wb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ab=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Tb=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Eb=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Cb=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,ce={alphahash_fragment:Jx,alphahash_pars_fragment:Kx,alphamap_fragment:jx,alphamap_pars_fragment:Qx,alphatest_fragment:ty,alphatest_pars_fragment:ey,aomap_fragment:ny,aomap_pars_fragment:iy,batching_pars_vertex:sy,batching_vertex:ry,begin_vertex:oy,beginnormal_vertex:ay,bsdfs:ly,iridescence_fragment:cy,bumpmap_pars_fragment:hy,clipping_planes_fragment:uy,clipping_planes_pars_fragment:fy,clipping_planes_pars_vertex:dy,clipping_planes_vertex:py,color_fragment:my,color_pars_fragment:gy,color_pars_vertex:_y,color_vertex:xy,common:yy,defaultnormal_vertex:vy,displacementmap_pars_vertex:by,displacementmap_vertex:Sy,emissivemap_fragment:My,emissivemap_pars_fragment:wy,colorspace_fragment:Ay,colorspace_pars_fragment:Ty,envmap_fragment:Ey,envmap_common_pars_fragment:Cy,envmap_pars_fragment:Ry,envmap_pars_vertex:Py,envmap_physical_pars_fragment:Vy,envmap_vertex:Iy,fog_vertex:Ly,fog_pars_vertex:Ny,fog_fragment:Dy,fog_pars_fragment:Uy,gradientmap_pars_fragment:Oy,lightmap_pars_fragment:Fy,lights_lambert_fragment:By,lights_lambert_pars_fragment:ky,lights_pars_begin:zy,lights_toon_fragment:Gy,lights_toon_pars_fragment:Hy,lights_phong_fragment:Wy,lights_phong_pars_fragment:Xy,lights_physical_fragment:qy,lights_physical_pars_fragment:$y,lights_fragment_begin:Yy,lights_fragment_maps:Zy,lights_fragment_end:Jy,lightprobes_pars_fragment:Ky,logdepthbuf_fragment:jy,logdepthbuf_pars_fragment:Qy,logdepthbuf_pars_vertex:tv,logdepthbuf_vertex:ev,map_fragment:nv,map_pars_fragment:iv,map_particle_fragment:sv,map_particle_pars_fragment:rv,metalnessmap_fragment:ov,metalnessmap_pars_fragment:av,morphinstance_vertex:lv,morphcolor_vertex:cv,morphnormal_vertex:hv,morphtarget_pars_vertex:uv,morphtarget_vertex:fv,normal_fragment_begin:dv,normal_fragment_maps:pv,normal_pars_fragment:mv,normal_pars_vertex:gv,normal_vertex:_v,normalmap_pars_fragment:xv,clearcoat_normal_fragment_begin:yv,clearcoat_normal_fragment_maps:vv,clearcoat_pars_fragment:bv,iridescence_pars_fragment:Sv,opaque_fragment:Mv,packing:wv,premultiplied_alpha_fragment:Av,project_vertex:Tv,dithering_fragment:Ev,dithering_pars_fragment:Cv,roughnessmap_fragment:Rv,roughnessmap_pars_fragment:Pv,shadowmap_pars_fragment:Iv,shadowmap_pars_vertex:Lv,shadowmap_vertex:Nv,shadowmask_pars_fragment:Dv,skinbase_vertex:Uv,skinning_pars_vertex:Ov,skinning_vertex:Fv,skinnormal_vertex:Bv,specularmap_fragment:kv,specularmap_pars_fragment:zv,tonemapping_fragment:Vv,tonemapping_pars_fragment:Gv,transmission_fragment:Hv,transmission_pars_fragment:Wv,uv_pars_fragment:Xv,uv_pars_vertex:qv,uv_vertex:$v,worldpos_vertex:Yv,background_vert:Zv,background_frag:Jv,backgroundCube_vert:Kv,backgroundCube_frag:jv,cube_vert:Qv,cube_frag:tb,depth_vert:eb,depth_frag:nb,distance_vert:ib,distance_frag:sb,equirect_vert:rb,equirect_frag:ob,linedashed_vert:ab,linedashed_frag:lb,meshbasic_vert:cb,meshbasic_frag:hb,meshlambert_vert:ub,meshlambert_frag:fb,meshmatcap_vert:db,meshmatcap_frag:pb,meshnormal_vert:mb,meshnormal_frag:gb,meshphong_vert:_b,meshphong_frag:xb,meshphysical_vert:yb,meshphysical_frag:vb,meshtoon_vert:bb,meshtoon_frag:Sb,points_vert:Mb,points_frag:wb,shadow_vert:Ab,shadow_frag:Tb,sprite_vert:Eb,sprite_frag:Cb},Lt={common:{diffuse:{value:new Qt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ee}},envmap:{envMap:{value:null},envMapRotation:{value:new ee},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ee}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ee}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ee},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ee},normalScale:{value:new Yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ee},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ee}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ee}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ee}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Qt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Qt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0},uvTransform:{value:new ee}},sprite:{diffuse:{value:new Qt(16777215)},opacity:{value:1},center:{value:new Yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ee},alphaMap:{value:null},alphaMapTransform:{value:new ee},alphaTest:{value:0}}},Yi={basic:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.fog]),vertexShader:ce.meshbasic_vert,fragmentShader:ce.meshbasic_frag},lambert:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},envMapIntensity:{value:1}}]),vertexShader:ce.meshlambert_vert,fragmentShader:ce.meshlambert_frag},phong:{uniforms:kn([Lt.common,Lt.specularmap,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},specular:{value:new Qt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ce.meshphong_vert,fragmentShader:ce.meshphong_frag},standard:{uniforms:kn([Lt.common,Lt.envmap,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.roughnessmap,Lt.metalnessmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag},toon:{uniforms:kn([Lt.common,Lt.aomap,Lt.lightmap,Lt.emissivemap,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.gradientmap,Lt.fog,Lt.lights,{emissive:{value:new Qt(0)}}]),vertexShader:ce.meshtoon_vert,fragmentShader:ce.meshtoon_frag},matcap:{uniforms:kn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,Lt.fog,{matcap:{value:null}}]),vertexShader:ce.meshmatcap_vert,fragmentShader:ce.meshmatcap_frag},points:{uniforms:kn([Lt.points,Lt.fog]),vertexShader:ce.points_vert,fragmentShader:ce.points_frag},dashed:{uniforms:kn([Lt.common,Lt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ce.linedashed_vert,fragmentShader:ce.linedashed_frag},depth:{uniforms:kn([Lt.common,Lt.displacementmap]),vertexShader:ce.depth_vert,fragmentShader:ce.depth_frag},normal:{uniforms:kn([Lt.common,Lt.bumpmap,Lt.normalmap,Lt.displacementmap,{opacity:{value:1}}]),vertexShader:ce.meshnormal_vert,fragmentShader:ce.meshnormal_frag},sprite:{uniforms:kn([Lt.sprite,Lt.fog]),vertexShader:ce.sprite_vert,fragmentShader:ce.sprite_frag},background:{uniforms:{uvTransform:{value:new ee},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ce.background_vert,fragmentShader:ce.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ee}},vertexShader:ce.backgroundCube_vert,fragmentShader:ce.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ce.cube_vert,fragmentShader:ce.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ce.equirect_vert,fragmentShader:ce.equirect_frag},distance:{uniforms:kn([Lt.common,Lt.displacementmap,{referencePosition:{value:new W},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ce.distance_vert,fragmentShader:ce.distance_frag},shadow:{uniforms:kn([Lt.lights,Lt.fog,{color:{value:new Qt(0)},opacity:{value:1}}]),vertexShader:ce.shadow_vert,fragmentShader:ce.shadow_frag}};Yi.physical={uniforms:kn([Yi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ee},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ee},clearcoatNormalScale:{value:new Yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ee},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ee},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ee},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ee},sheen:{value:0},sheenColor:{value:new Qt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ee},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ee},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ee},transmissionSamplerSize:{value:new Yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ee},attenuationDistance:{value:0},attenuationColor:{value:new Qt(0)},specularColor:{value:new Qt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ee},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ee},anisotropyVector:{value:new Yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ee}}]),vertexShader:ce.meshphysical_vert,fragmentShader:ce.meshphysical_frag};var Vc={r:0,b:0,g:0},Rb=new pe,ym=new ee;ym.set(-1,0,0,0,1,0,0,0,1);function Pb(n,t,e,i,s,r){let o=new Qt(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function d(_){let w=_.isScene===!0?_.background:null;if(w&&w.isTexture){let b=_.backgroundBlurriness>0;w=t.get(w,b)}return w}function p(_){let w=!1,b=d(_);b===null?g(o,a):b&&b.isColor&&(g(b,1),w=!0);let S=n.xr.getEnvironmentBlendMode();S==="additive"?e.buffers.color.setClear(0,0,0,1,r):S==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(_,w){let b=d(w);b&&b.isCubeTexture?(c===void 0&&(c=new Ln(new eo(1,1,1),new Xi({name:"BackgroundCubeMaterial",uniforms:ur(Yi.backgroundCube.uniforms),vertexShader:Yi.backgroundCube.vertexShader,fragmentShader:Yi.backgroundCube.fragmentShader,side:$n,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(S,M,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=b,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(Rb.makeRotationFromEuler(w.backgroundRotation)).transpose(),b.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(ym),c.material.toneMapped=_e.getTransfer(b.colorSpace)!==Ae,(h!==b||u!==b.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=b,u=b.version,f=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null)):b&&b.isTexture&&(l===void 0&&(l=new Ln(new la(2,2),new Xi({name:"BackgroundMaterial",uniforms:ur(Yi.background.uniforms),vertexShader:Yi.background.vertexShader,fragmentShader:Yi.background.fragmentShader,side:Hs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=b,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=_e.getTransfer(b.colorSpace)!==Ae,b.matrixAutoUpdate===!0&&b.updateMatrix(),l.material.uniforms.uvTransform.value.copy(b.matrix),(h!==b||u!==b.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,h=b,u=b.version,f=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null))}function g(_,w){_.getRGB(Vc,Yu(n)),e.buffers.color.setClear(Vc.r,Vc.g,Vc.b,w,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,w=1){o.set(_),a=w,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:x,dispose:m}}function Ib(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(R,F,z,U,G){let q=!1,H=u(R,U,z,F);r!==H&&(r=H,c(r.object)),q=d(R,U,z,G),q&&p(R,U,z,G),G!==null&&t.update(G,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,b(R,F,z,U),G!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(G).buffer))}function l(){return n.createVertexArray()}function c(R){return n.bindVertexArray(R)}function h(R){return n.deleteVertexArray(R)}function u(R,F,z,U){let G=U.wireframe===!0,q=i[F.id];q===void 0&&(q={},i[F.id]=q);let H=R.isInstancedMesh===!0?R.id:0,lt=q[H];lt===void 0&&(lt={},q[H]=lt);let J=lt[z.id];J===void 0&&(J={},lt[z.id]=J);let Q=J[G];return Q===void 0&&(Q=f(l()),J[G]=Q),Q}function f(R){let F=[],z=[],U=[];for(let G=0;G<e;G++)F[G]=0,z[G]=0,U[G]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:z,attributeDivisors:U,object:R,attributes:{},index:null}}function d(R,F,z,U){let G=r.attributes,q=F.attributes,H=0,lt=z.getAttributes();for(let J in lt)if(lt[J].location>=0){let it=G[J],dt=q[J];if(dt===void 0&&(J==="instanceMatrix"&&R.instanceMatrix&&(dt=R.instanceMatrix),J==="instanceColor"&&R.instanceColor&&(dt=R.instanceColor)),it===void 0||it.attribute!==dt||dt&&it.data!==dt.data)return!0;H++}return r.attributesNum!==H||r.index!==U}function p(R,F,z,U){let G={},q=F.attributes,H=0,lt=z.getAttributes();for(let J in lt)if(lt[J].location>=0){let it=q[J];it===void 0&&(J==="instanceMatrix"&&R.instanceMatrix&&(it=R.instanceMatrix),J==="instanceColor"&&R.instanceColor&&(it=R.instanceColor));let dt={};dt.attribute=it,it&&it.data&&(dt.data=it.data),G[J]=dt,H++}r.attributes=G,r.attributesNum=H,r.index=U}function x(){let R=r.newAttributes;for(let F=0,z=R.length;F<z;F++)R[F]=0}function g(R){m(R,0)}function m(R,F){let z=r.newAttributes,U=r.enabledAttributes,G=r.attributeDivisors;z[R]=1,U[R]===0&&(n.enableVertexAttribArray(R),U[R]=1),G[R]!==F&&(n.vertexAttribDivisor(R,F),G[R]=F)}function _(){let R=r.newAttributes,F=r.enabledAttributes;for(let z=0,U=F.length;z<U;z++)F[z]!==R[z]&&(n.disableVertexAttribArray(z),F[z]=0)}function w(R,F,z,U,G,q,H){H===!0?n.vertexAttribIPointer(R,F,z,G,q):n.vertexAttribPointer(R,F,z,U,G,q)}function b(R,F,z,U){x();let G=U.attributes,q=z.getAttributes(),H=F.defaultAttributeValues;for(let lt in q){let J=q[lt];if(J.location>=0){let Q=G[lt];if(Q===void 0&&(lt==="instanceMatrix"&&R.instanceMatrix&&(Q=R.instanceMatrix),lt==="instanceColor"&&R.instanceColor&&(Q=R.instanceColor)),Q!==void 0){let it=Q.normalized,dt=Q.itemSize,ft=t.get(Q);if(ft===void 0)continue;let tt=ft.buffer,ut=ft.type,gt=ft.bytesPerElement,St=ut===n.INT||ut===n.UNSIGNED_INT||Q.gpuType===ic;if(Q.isInterleavedBufferAttribute){let Mt=Q.data,Ht=Mt.isInterleavedBuffer===!0?Mt.stride:Mt.itemSize,se=Q.offset;if(Mt.isInstancedInterleavedBuffer||Mt.isInstancedBufferAttribute){for(let Vt=0;Vt<J.locationSize;Vt++)m(J.location+Vt,Mt.meshPerAttribute);R.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Mt.meshPerAttribute*Mt.count)}else for(let Vt=0;Vt<J.locationSize;Vt++)g(J.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Vt=0;Vt<J.locationSize;Vt++)w(J.location+Vt,dt/J.locationSize,ut,it,Ht*gt,(se+dt/J.locationSize*Vt)*gt,St)}else{if(Q.isInstancedBufferAttribute){for(let Mt=0;Mt<J.locationSize;Mt++)m(J.location+Mt,Q.meshPerAttribute);R.isInstancedMesh!==!0&&U._maxInstanceCount===void 0&&(U._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let Mt=0;Mt<J.locationSize;Mt++)g(J.location+Mt);n.bindBuffer(n.ARRAY_BUFFER,tt);for(let Mt=0;Mt<J.locationSize;Mt++)w(J.location+Mt,dt/J.locationSize,ut,it,dt*gt,dt/J.locationSize*Mt*gt,St)}}else if(H!==void 0){let it=H[lt];if(it!==void 0)switch(it.length){case 2:n.vertexAttrib2fv(J.location,it);break;case 3:n.vertexAttrib3fv(J.location,it);break;case 4:n.vertexAttrib4fv(J.location,it);break;default:n.vertexAttrib1fv(J.location,it)}}}}_()}function S(){I();for(let R in i){let F=i[R];for(let z in F){let U=F[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete i[R]}}function M(R){if(i[R.id]===void 0)return;let F=i[R.id];for(let z in F){let U=F[z];for(let G in U){let q=U[G];for(let H in q)h(q[H].object),delete q[H];delete U[G]}}delete i[R.id]}function y(R){for(let F in i){let z=i[F];for(let U in z){let G=z[U];if(G[R.id]===void 0)continue;let q=G[R.id];for(let H in q)h(q[H].object),delete q[H];delete G[R.id]}}}function T(R){for(let F in i){let z=i[F],U=R.isInstancedMesh===!0?R.id:0,G=z[U];if(G!==void 0){for(let q in G){let H=G[q];for(let lt in H)h(H[lt].object),delete H[lt];delete G[q]}delete z[U],Object.keys(z).length===0&&delete i[F]}}}function I(){P(),o=!0,r!==s&&(r=s,c(r.object))}function P(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:I,resetDefaultState:P,dispose:S,releaseStatesOfGeometry:M,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:x,enableAttribute:g,disableUnusedAttributes:_}}function Lb(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let f=0;for(let d=0;d<h;d++)f+=c[d];e.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Nb(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Pi&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let T=y===Ri&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Jn&&y!==_i&&!T&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(qt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&qt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&qt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),b=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),S=n.getParameter(n.MAX_SAMPLES),M=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:d,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:_,maxVaryings:w,maxFragmentUniforms:b,maxSamples:S,samples:M}}function Db(n){let t=this,e=null,i=0,s=!1,r=!1,o=new ri,a=new ee,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let d=u.length!==0||f||i!==0||s;return s=f,i=u.length,d},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,d){let p=u.clippingPlanes,x=u.clipIntersection,g=u.clipShadows,m=n.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):c();else{let _=r?0:i,w=_*4,b=m.clippingState||null;l.value=b,b=h(p,f,w,d);for(let S=0;S!==w;++S)b[S]=e[S];m.clippingState=b,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=_}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,f,d,p){let x=u!==null?u.length:0,g=null;if(x!==0){if(g=l.value,p!==!0||g===null){let m=d+x*4,_=f.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<m)&&(g=new Float32Array(m));for(let w=0,b=d;w!==x;++w,b+=4)o.copy(u[w]).applyMatrix4(_,a),o.normal.toArray(g,b),g[b+3]=o.constant}l.value=g,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,g}}var Ca=class extends ai{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new sa(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new eo(5,5,5),r=new Xi({name:"CubemapFromEquirect",uniforms:ur(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:$n,blending:ar});r.uniforms.tEquirect.value=e;let o=new Ln(s,r),a=e.minFilter;return e.minFilter===ps&&(e.minFilter=qn),new io(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Kp=256,Ub=3,Ob=20,vm=256,bm=16,Fb=3,Bb=new W,kb=new Qt,Hc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new io(1,10,null),this._boxMesh=new Ln(new eo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=Bb}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(kb));let g=new io(i,s,h);return g.position.copy(a),g.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=d,l.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=tm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Qp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Kp,Xu(t))}_fromTexture(t,e){t.mapping===cr||t.mapping===ao?this._setSize(t.image.length===0?Kp:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=jp(t,!1,!1),i=Math.log2(t)-Ub;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=jp(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===cr||t.mapping===ao?(this._cubemapMaterial===null&&(this._cubemapMaterial=tm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Qp()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=zb(),this._integrationMaterial=Vb());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/bm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-Fb)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(vm*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Gb());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function jp(n,t,e){return new Ca(n,{minFilter:ps,generateMipmaps:t,type:Ri,colorSpace:Zo,depthBuffer:e})}function Ra(n,t,e){return new Xi({name:n,uniforms:t,vertexShader:ce.cube_vert,fragmentShader:e,side:$n,blending:ar,depthTest:!1,depthWrite:!1})}function zb(){return Ra("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${vm}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Vb(){return Ra("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:bm}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Gb(){return Ra("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${Ob}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Qp(){return Ra("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function tm(){return Ra("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Hb(n){let t=new WeakMap,e=new WeakMap,i=null;function s(f,d=!1){return f==null?null:d?o(f):r(f)}function r(f){if(f&&f.isTexture){let d=f.mapping;if(d===tc||d===ec)if(t.has(f)){let p=t.get(f).texture;return a(p,f.mapping)}else{let p=f.image;if(p&&p.height>0){let x=new Ca(p.height);return x.fromEquirectangularTexture(n,f),t.set(f,x),f.addEventListener("dispose",c),a(x.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let d=f.mapping,p=d===tc||d===ec,x=d===cr||d===ao;if(p||x){let g=e.get(f),m=g!==void 0?g.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==m)return i===null&&(i=new Hc(n)),g=p?i.fromEquirectangular(f,g):i.fromCubemap(f,g),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),g.texture;if(g!==void 0)return g.texture;{let _=f.image;return p&&_&&_.height>0||x&&_&&l(_)?(i===null&&(i=new Hc(n)),g=p?i.fromEquirectangular(f):i.fromCubemap(f),g.texture.pmremVersion=f.pmremVersion,e.set(f,g),f.addEventListener("dispose",h),g.texture):null}}}return f}function a(f,d){return d===tc?f.mapping=cr:d===ec&&(f.mapping=ao),f}function l(f){let d=0,p=6;for(let x=0;x<p;x++)f[x]!==void 0&&d++;return d===p}function c(f){let d=f.target;d.removeEventListener("dispose",c);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function h(f){let d=f.target;d.removeEventListener("dispose",h);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function Wb(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Xo("WebGLRenderer: "+i+" extension not supported."),s}}}function Xb(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function c(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let g in x)t.update(x[g],n.ARRAY_BUFFER)}function u(p){let x=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let _=x!==null?x.array.length:g.array.length/3-1,w=g.count>=65535?ea:ta,b=new w(Math.ceil(_/3)*6,1),S=b.array;if(x!==null){let y=x.array;m=x.version;for(let T=0,I=0;T<_;T+=3){let P=y[T+0],R=y[T+1],F=y[T+2];S[I++]=P,S[I++]=R,S[I++]=R,S[I++]=F,S[I++]=F,S[I++]=P}}else{m=g.version;for(let y=0,T=0;y<_;y+=3){let I=y+0,P=y+1,R=y+2;S[T++]=I,S[T++]=P,S[T++]=P,S[T++]=R,S[T++]=R,S[T++]=I}}b.version=m;let M=r.get(p);M&&t.remove(M),r.set(p,b)}function f(p){let x=r.get(p);if(x){let g=p.index;g!==null&&x.version<g.version&&u(p)}else u(p);return r.get(p)}function d(){for(let p in s){let x=s[p].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:f,dispose:d}}function qb(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){n.drawElements(i,f,r,u*o),e.update(f,i,1)}function c(u,f,d){d!==0&&(n.drawElementsInstanced(i,f,r,u*o,d),e.update(f,i,d))}function h(u,f,d){if(d===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,u,0,d);let x=0;for(let g=0;g<d;g++)x+=f[g];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function $b(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:jt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Yb(n,t,e){let i=new WeakMap,s=new qe;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=i.get(a);if(f===void 0||f.count!==u){let I=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",I)};f!==void 0&&f.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],w=0;d===!0&&(w=1),p===!0&&(w=2),x===!0&&(w=3);let b=a.attributes.position.count*w,S=1;b>t.maxTextureSize&&(S=Math.ceil(b/t.maxTextureSize),b=t.maxTextureSize);let M=new Float32Array(b*S*4*u),y=new jo(M,b,S,u);y.type=_i,y.needsUpdate=!0;let T=w*4;for(let P=0;P<u;P++){let R=g[P],F=m[P],z=_[P],U=b*S*4*P;for(let G=0;G<R.count;G++){let q=G*T;d===!0&&(s.fromBufferAttribute(R,G),M[U+q+0]=s.x,M[U+q+1]=s.y,M[U+q+2]=s.z,M[U+q+3]=0),p===!0&&(s.fromBufferAttribute(F,G),M[U+q+4]=s.x,M[U+q+5]=s.y,M[U+q+6]=s.z,M[U+q+7]=0),x===!0&&(s.fromBufferAttribute(z,G),M[U+q+8]=s.x,M[U+q+9]=s.y,M[U+q+10]=s.z,M[U+q+11]=z.itemSize===4?s.w:1)}}f={count:u,texture:y,size:new Yt(b,S)},i.set(a,f),a.addEventListener("dispose",I)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let d=0;for(let x=0;x<c.length;x++)d+=c[x];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Zb(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==h&&(d.update(),r.set(d,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Jb={[Mu]:"LINEAR_TONE_MAPPING",[wu]:"REINHARD_TONE_MAPPING",[Au]:"CINEON_TONE_MAPPING",[Tu]:"ACES_FILMIC_TONE_MAPPING",[Cu]:"AGX_TONE_MAPPING",[Ru]:"NEUTRAL_TONE_MAPPING",[Eu]:"CUSTOM_TONE_MAPPING"};function Kb(n,t,e,i,s,r){let o=new ai(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new gn;h.setAttribute("position",new Qe([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Qe([0,2,0,0,2,0],2));let u=new Bl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),f=new Ln(h,u),d=new da(-1,1,1,-1,0,1),p=null,x=null,g=!1,m,_=null,w=[],b=!1;this.setSize=function(S,M){o.setSize(S,M),a!==null&&a.setSize(S,M),l!==null&&l.setSize(S,M);for(let y=0;y<w.length;y++){let T=w[y];T.setSize&&T.setSize(S,M)}},this.setEffects=function(S){w=S,b=w.length>0&&w[0].isRenderPass===!0;let M=o.width,y=o.height;w.length>0&&a===null&&(a=new ai(M,y,{type:Ri,depthBuffer:!1,stencilBuffer:!1}),l=new ai(M,y,{type:Ri,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&w.some(I=>I.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new fs(M,y),r===!0&&(c.format=ms,c.type=hr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let I=0;I<w.length;I++){let P=w[I];P.setSize&&P.setSize(M,y),T&&P.needsDepthTexture===!0&&P.setDepthTexture&&P.setDepthTexture(c)}},this.begin=function(S,M){if(g||S.toneMapping===qi&&w.length===0)return!1;if(_=M,M!==null){let y=M.width,T=M.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return b===!1&&S.setRenderTarget(o),m=S.toneMapping,S.toneMapping=qi,!0},this.hasRenderPass=function(){return b},this.end=function(S,M){S.toneMapping=m,g=!0;let y=o,T=a;for(let I=0;I<w.length;I++){let P=w[I];P.enabled!==!1&&(P.render(S,T,y,M),P.needsSwap!==!1&&(y=T,T=T===a?l:a))}if(p!==S.outputColorSpace||x!==S.toneMapping){p=S.outputColorSpace,x=S.toneMapping,u.defines={},_e.getTransfer(p)===Ae&&(u.defines.SRGB_TRANSFER="");let I=Jb[x];I&&(u.defines[I]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,S.setRenderTarget(_),S.render(f,d),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var Sm=new Zn,Mm=new fs(1,1),wm=new ra(1),Am=new jo,Tm=new Nl,Em=new sa,em=[],nm=[],im=new Float32Array(16),sm=new Float32Array(9),rm=new Float32Array(4);function uo(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=em[s];if(r===void 0&&(r=new Float32Array(s),em[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function _n(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function xn(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Xc(n,t){let e=nm[t];e===void 0&&(e=new Int32Array(t),nm[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function jb(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Qb(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2fv(this.addr,t),xn(e,t)}}function tS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(_n(e,t))return;n.uniform3fv(this.addr,t),xn(e,t)}}function eS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4fv(this.addr,t),xn(e,t)}}function nS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),xn(e,t)}else{if(_n(e,i))return;rm.set(i),n.uniformMatrix2fv(this.addr,!1,rm),xn(e,i)}}function iS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),xn(e,t)}else{if(_n(e,i))return;sm.set(i),n.uniformMatrix3fv(this.addr,!1,sm),xn(e,i)}}function sS(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(_n(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),xn(e,t)}else{if(_n(e,i))return;im.set(i),n.uniformMatrix4fv(this.addr,!1,im),xn(e,i)}}function rS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function oS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2iv(this.addr,t),xn(e,t)}}function aS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(_n(e,t))return;n.uniform3iv(this.addr,t),xn(e,t)}}function lS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4iv(this.addr,t),xn(e,t)}}function cS(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function hS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(_n(e,t))return;n.uniform2uiv(this.addr,t),xn(e,t)}}function uS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(_n(e,t))return;n.uniform3uiv(this.addr,t),xn(e,t)}}function fS(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(_n(e,t))return;n.uniform4uiv(this.addr,t),xn(e,t)}}function qc(n){return n.version===0&&(n.compareFunction=Vu,n.needsUpdate=!0),n}function dS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=qc(Mm):r=Sm,e.setTexture2D(t||r,s)}function pS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||Tm,s)}function mS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=qc(wm):r=Em,e.setTextureCube(t||r,s)}function gS(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||Am,s)}function _S(n){switch(n){case 5126:return jb;case 35664:return Qb;case 35665:return tS;case 35666:return eS;case 35674:return nS;case 35675:return iS;case 35676:return sS;case 5124:case 35670:return rS;case 35667:case 35671:return oS;case 35668:case 35672:return aS;case 35669:case 35673:return lS;case 5125:return cS;case 36294:return hS;case 36295:return uS;case 36296:return fS;case 35678:case 36198:case 36298:case 36306:case 35682:return dS;case 35679:case 36299:case 36307:return pS;case 35680:case 36300:case 36308:case 36293:return mS;case 36289:case 36303:case 36311:case 36292:return gS}}function xS(n,t){n.uniform1fv(this.addr,t)}function yS(n,t){let e=uo(t,this.size,2);n.uniform2fv(this.addr,e)}function vS(n,t){let e=uo(t,this.size,3);n.uniform3fv(this.addr,e)}function bS(n,t){let e=uo(t,this.size,4);n.uniform4fv(this.addr,e)}function SS(n,t){let e=uo(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function MS(n,t){let e=uo(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function wS(n,t){let e=uo(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function AS(n,t){n.uniform1iv(this.addr,t)}function TS(n,t){n.uniform2iv(this.addr,t)}function ES(n,t){n.uniform3iv(this.addr,t)}function CS(n,t){n.uniform4iv(this.addr,t)}function RS(n,t){n.uniform1uiv(this.addr,t)}function PS(n,t){n.uniform2uiv(this.addr,t)}function IS(n,t){n.uniform3uiv(this.addr,t)}function LS(n,t){n.uniform4uiv(this.addr,t)}function NS(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=qc(Mm):o=Sm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function DS(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Tm,r[o])}function US(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=qc(wm):o=Em;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function OS(n,t,e){let i=this.cache,s=t.length,r=Xc(e,s);_n(i,r)||(n.uniform1iv(this.addr,r),xn(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Am,r[o])}function FS(n){switch(n){case 5126:return xS;case 35664:return yS;case 35665:return vS;case 35666:return bS;case 35674:return SS;case 35675:return MS;case 35676:return wS;case 5124:case 35670:return AS;case 35667:case 35671:return TS;case 35668:case 35672:return ES;case 35669:case 35673:return CS;case 5125:return RS;case 36294:return PS;case 36295:return IS;case 36296:return LS;case 35678:case 36198:case 36298:case 36306:case 35682:return NS;case 35679:case 36299:case 36307:return DS;case 35680:case 36300:case 36308:case 36293:return US;case 36289:case 36303:case 36311:case 36292:return OS}}var tf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=_S(e.type)}},ef=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=FS(e.type)}},nf=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},ju=/(\w+)(\])?(\[|\.)?/g;function om(n,t){n.seq.push(t),n.map[t.id]=t}function BS(n,t,e){let i=n.name,s=i.length;for(ju.lastIndex=0;;){let r=ju.exec(i),o=ju.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){om(e,c===void 0?new tf(a,n,t):new ef(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new nf(a),om(e,u)),e=u}}}var ho=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);BS(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function am(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var kS=37297,zS=0;function VS(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var lm=new ee;function GS(n){_e._getMatrix(lm,_e.workingColorSpace,n);let t=`mat3( ${lm.elements.map(e=>e.toFixed(4))} )`;switch(_e.getTransfer(n)){case Jo:return[t,"LinearTransferOETF"];case Ae:return[t,"sRGBTransferOETF"];default:return qt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function cm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+VS(n.getShaderSource(t),a)}else return r}function HS(n,t){let e=GS(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var WS={[Mu]:"Linear",[wu]:"Reinhard",[Au]:"Cineon",[Tu]:"ACESFilmic",[Cu]:"AgX",[Ru]:"Neutral",[Eu]:"Custom"};function XS(n,t){let e=WS[t];return e===void 0?(qt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Gc=new W;function qS(){_e.getLuminanceCoefficients(Gc);let n=Gc.x.toFixed(4),t=Gc.y.toFixed(4),e=Gc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function $S(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ea).join(`
`)}function YS(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function ZS(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Ea(n){return n!==""}function hm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function um(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var JS=/^[ \t]*#include +<([\w\d./]+)>/gm;function sf(n){return n.replace(JS,KS)}function KS(n,t){let e=ce[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return sf(e)}var jS=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function fm(n){return n.replace(jS,QS)}function QS(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function dm(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var tM={[_a]:"SHADOWMAP_TYPE_PCF",[ro]:"SHADOWMAP_TYPE_VSM"};function eM(n){return tM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var nM={[ao]:"ENVMAP_MODE_REFRACTION"};function iM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":nM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var sM={[Ql]:"ENVMAP_BLENDING_MULTIPLY",[Rp]:"ENVMAP_BLENDING_MIX",[Pp]:"ENVMAP_BLENDING_ADD"};function rM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":sM[n.combine]||"ENVMAP_BLENDING_NONE"}function oM(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=eM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=iM(e),u=rM(e),f=$S(e),d=YS(r),p=s.createProgram(),x,g,m=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ea).join(`
`),x.length>0&&(x+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d].filter(Ea).join(`
`),g.length>0&&(g+=`
`)):(x=[dm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ea).join(`
`),g=[dm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,d,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==qi?"#define TONE_MAPPING":"",e.toneMapping!==qi?ce.tonemapping_pars_fragment:"",e.toneMapping!==qi?XS("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",ce.colorspace_pars_fragment,HS("linearToOutputTexel",e.outputColorSpace),qS(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Ea).join(`
`)),o=sf(o),o=hm(o,e),o=um(o,e),a=sf(a),a=hm(a,e),a=um(a,e),o=fm(o),a=fm(a),e.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,x=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,g=["#define varying in",e.glslVersion===Gu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Gu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=m+x+o,w=m+g+a,b=am(s,s.VERTEX_SHADER,_),S=am(s,s.FRAGMENT_SHADER,w);s.attachShader(p,b),s.attachShader(p,S),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function M(P){if(n.debug.checkShaderErrors){let R=s.getProgramInfoLog(p)||"",F=s.getShaderInfoLog(b)||"",z=s.getShaderInfoLog(S)||"",U=R.trim(),G=F.trim(),q=z.trim(),H=!0,lt=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,b,S);else{let J=cm(s,b,"vertex"),Q=cm(s,S,"fragment");jt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+P.name+`
Material Type: `+P.type+`

Program Info Log: `+U+`
`+J+`
`+Q)}else U!==""?qt("WebGLProgram: Program Info Log:",U):(G===""||q==="")&&(lt=!1);lt&&(P.diagnostics={runnable:H,programLog:U,vertexShader:{log:G,prefix:x},fragmentShader:{log:q,prefix:g}})}s.deleteShader(b),s.deleteShader(S),y=new ho(s,p),T=ZS(s,p)}let y;this.getUniforms=function(){return y===void 0&&M(this),y};let T;this.getAttributes=function(){return T===void 0&&M(this),T};let I=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return I===!1&&(I=s.getProgramParameter(p,kS)),I},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=zS++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=b,this.fragmentShader=S,this}var aM=0,rf=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new of(t),e.set(t,i)),i}},of=class{constructor(t){this.id=aM++,this.code=t,this.usedTimes=0}};function lM(n){return n===Ws||n===Ma||n===wa}function cM(n,t,e,i,s,r){let o=new Qr,a=new rf,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,T,I,P,R,F){let z=P.fog,U=R.geometry,G=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?P.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=t.get(y.envMap||G,q),lt=f[y.type],J=i.precision;y.precision!==null&&(J=i.getMaxPrecision(y.precision),J!==y.precision&&qt("WebGLProgram.getParameters:",y.precision,"not supported, using",J,"instead."));let Q=U.morphAttributes.position||U.morphAttributes.normal||U.morphAttributes.color,it=Q!==void 0?Q.length:0,dt=0;U.morphAttributes.position!==void 0&&(dt=1),U.morphAttributes.normal!==void 0&&(dt=2),U.morphAttributes.color!==void 0&&(dt=3);let ft,tt,ut,gt;if(lt){let Ct=Yi[lt];ft=Ct.vertexShader,tt=Ct.fragmentShader}else{ft=y.vertexShader,tt=y.fragmentShader;let Ct=a.getVertexShaderStage(y),oe=a.getFragmentShaderStage(y);a.update(y,Ct,oe),ut=Ct.id,gt=oe.id}let St=n.getRenderTarget(),Mt=n.state.buffers.depth.getReversed(),Ht=R.isInstancedMesh===!0,se=R.isBatchedMesh===!0,Vt=!!y.map,he=!!y.matcap,ae=!!H,ne=ae&&H.isPMREMTexture===!0,We=!!y.aoMap,Oe=!!y.lightMap,on=!!y.bumpMap&&y.wireframe===!1,Ie=!!y.normalMap,Sn=!!y.displacementMap,ye=!!y.emissiveMap,pn=!!y.metalnessMap,Ye=!!y.roughnessMap,an=y.anisotropy>0,k=y.clearcoat>0,Rt=y.diffuseRoughness>0,$t=y.dispersion>0,re=y.retroreflectivity>0,wt=y.iridescence>0,Ne=y.sheen>0,zt=y.transmission>0,Xt=an&&!!y.anisotropyMap,L=k&&!!y.clearcoatMap,A=k&&!!y.clearcoatNormalMap,$=k&&!!y.clearcoatRoughnessMap,ht=Rt&&!!y.diffuseRoughnessMap,ot=wt&&!!y.iridescenceMap,xt=wt&&!!y.iridescenceThicknessMap,yt=Ne&&!!y.sheenColorMap,et=Ne&&!!y.sheenRoughnessMap,st=!!y.specularMap,mt=!!y.specularColorMap,B=!!y.specularIntensityMap,rt=zt&&!!y.transmissionMap,nt=zt&&!!y.thicknessMap,At=!!y.gradientMap,_t=!!y.alphaMap,bt=y.alphaTest>0,Gt=!!y.alphaHash,Jt=!!y.extensions,ct=qi;y.toneMapped&&(St===null||St.isXRRenderTarget===!0)&&(ct=n.toneMapping);let Ft=ne?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Kt={shaderID:lt,shaderType:y.type,shaderName:y.name,vertexShader:ft,fragmentShader:tt,defines:y.defines,customVertexShaderID:ut,customFragmentShaderID:gt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:J,batching:se,batchingColor:se&&R._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&R.instanceColor!==null,instancingMorph:Ht&&R.morphTexture!==null,outputColorSpace:St===null?n.outputColorSpace:St.isXRRenderTarget===!0?St.texture.colorSpace:_e.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:he,envMap:ae,envMapMode:ae&&H.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ft.length-1:null,envMapSize:ne?Ft[0].width:null,aoMap:We,lightMap:Oe,bumpMap:on,normalMap:Ie,displacementMap:Sn,emissiveMap:ye,normalMapObjectSpace:Ie&&y.normalMapType===Np,normalMapTangentSpace:Ie&&y.normalMapType===zc,packedNormalMap:Ie&&y.normalMapType===zc&&lM(y.normalMap.format),metalnessMap:pn,roughnessMap:Ye,anisotropy:an,anisotropyMap:Xt,clearcoat:k,clearcoatMap:L,clearcoatNormalMap:A,clearcoatRoughnessMap:$,diffuseRoughness:Rt,diffuseRoughnessMap:ht,dispersion:$t,retroreflection:re,iridescence:wt,iridescenceMap:ot,iridescenceThicknessMap:xt,sheen:Ne,sheenColorMap:yt,sheenRoughnessMap:et,specularMap:st,specularColorMap:mt,specularIntensityMap:B,transmission:zt,transmissionMap:rt,thicknessMap:nt,gradientMap:At,opaque:y.transparent===!1&&y.blending===oo&&y.alphaToCoverage===!1,alphaMap:_t,alphaTest:bt,alphaHash:Gt,combine:y.combine,mapUv:Vt&&d(y.map.channel),aoMapUv:We&&d(y.aoMap.channel),lightMapUv:Oe&&d(y.lightMap.channel),bumpMapUv:on&&d(y.bumpMap.channel),normalMapUv:Ie&&d(y.normalMap.channel),displacementMapUv:Sn&&d(y.displacementMap.channel),emissiveMapUv:ye&&d(y.emissiveMap.channel),metalnessMapUv:pn&&d(y.metalnessMap.channel),roughnessMapUv:Ye&&d(y.roughnessMap.channel),anisotropyMapUv:Xt&&d(y.anisotropyMap.channel),clearcoatMapUv:L&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:A&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ht&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:ot&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:xt&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:yt&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:et&&d(y.sheenRoughnessMap.channel),specularMapUv:st&&d(y.specularMap.channel),specularColorMapUv:mt&&d(y.specularColorMap.channel),specularIntensityMapUv:B&&d(y.specularIntensityMap.channel),transmissionMapUv:rt&&d(y.transmissionMap.channel),thicknessMapUv:nt&&d(y.thicknessMap.channel),alphaMapUv:_t&&d(y.alphaMap.channel),vertexTangents:!!U.attributes.tangent&&(Ie||an),vertexNormals:!!U.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!U.attributes.color&&U.attributes.color.itemSize===4,pointsUvs:R.isPoints===!0&&!!U.attributes.uv&&(Vt||_t),fog:!!z,useFog:y.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||U.attributes.normal===void 0&&Ie===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:Mt,skinning:R.isSkinnedMesh===!0,hasPositionAttribute:U.attributes.position!==void 0,morphTargets:U.morphAttributes.position!==void 0,morphNormals:U.morphAttributes.normal!==void 0,morphColors:U.morphAttributes.color!==void 0,morphTargetsCount:it,morphTextureStride:dt,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:F.filter(Ct=>Ct.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&I.length>0,shadowMapType:n.shadowMap.type,toneMapping:ct,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&_e.getTransfer(y.map.colorSpace)===Ae,decodeVideoTextureEmissive:ye&&y.emissiveMap.isVideoTexture===!0&&_e.getTransfer(y.emissiveMap.colorSpace)===Ae,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Bn,flipSided:y.side===$n,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Jt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Jt&&y.extensions.multiDraw===!0||se)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Kt.vertexUv1s=l.has(1),Kt.vertexUv2s=l.has(2),Kt.vertexUv3s=l.has(3),l.clear(),Kt}function x(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let I in y.defines)T.push(I),T.push(y.defines[I]);return y.isRawShaderMaterial===!1&&(g(T,y),m(T,y),T.push(n.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}function g(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}function m(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let T=f[y.type],I;if(T){let P=Yi[T];I=Yp.clone(P.uniforms)}else I=y.uniforms;return I}function w(y,T){let I=h.get(T);return I!==void 0?++I.usedTimes:(I=new oM(n,T,y,s),c.push(I),h.set(T,I)),I}function b(y){if(--y.usedTimes===0){let T=c.indexOf(y);c[T]=c[c.length-1],c.pop(),h.delete(y.cacheKey),y.destroy()}}function S(y){a.remove(y)}function M(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:_,acquireProgram:w,releaseProgram:b,releaseShaderCache:S,programs:c,dispose:M}}function hM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function uM(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function pm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function mm(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(f){let d=0;return f.isInstancedMesh&&(d+=2),f.isSkinnedMesh&&(d+=1),d}function a(f,d,p,x,g,m){let _=n[t];return _===void 0?(_={id:f.id,object:f,geometry:d,material:p,materialVariant:o(f),groupOrder:x,renderOrder:f.renderOrder,z:g,group:m},n[t]=_):(_.id=f.id,_.object=f,_.geometry=d,_.material=p,_.materialVariant=o(f),_.groupOrder=x,_.renderOrder=f.renderOrder,_.z=g,_.group=m),t++,_}function l(f,d,p,x,g,m,_){_.reversedDepth===!0&&(g=-g);let w=a(f,d,p,x,g,m);p.transmission>0?i.push(w):p.transparent===!0?s.push(w):e.push(w)}function c(f,d,p,x,g,m){let _=a(f,d,p,x,g,m);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(f,d){e.length>1&&e.sort(f||uM),i.length>1&&i.sort(d||pm),s.length>1&&s.sort(d||pm)}function u(){for(let f=t,d=n.length;f<d;f++){let p=n[f];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function fM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new mm,n.set(i,[o])):s>=r.length?(o=new mm,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function dM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new W,color:new Qt};break;case"SpotLight":e={position:new W,direction:new W,color:new Qt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new W,color:new Qt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new W,skyColor:new Qt,groundColor:new Qt};break;case"RectAreaLight":e={color:new Qt,position:new W,halfWidth:new W,halfHeight:new W};break}return n[t.id]=e,e}}}function pM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var mM=0;function gM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function _M(n){let t=new dM,e=pM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new W);let s=new W,r=new pe,o=new pe;function a(c){let h=0,u=0,f=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let d=0,p=0,x=0,g=0,m=0,_=0,w=0,b=0,S=0,M=0,y=0,T=0,I=0,P=0;c.sort(gM);for(let F=0,z=c.length;F<z;F++){let U=c[F],G=U.color,q=U.intensity,H=U.distance,lt=null;if(U.shadow&&U.shadow.map&&(U.shadow.map.texture.format===Ws?lt=U.shadow.map.texture:lt=U.shadow.map.depthTexture||U.shadow.map.texture),U.isAmbientLight)h+=G.r*q,u+=G.g*q,f+=G.b*q;else if(U.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(U.sh.coefficients[J],q);P++}else if(U.isSunLight){let J=t.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=it,i.sunShadowMap[p]=lt;let dt=Q.getViewportCount();for(let ft=0;ft<dt;ft++)i.sunShadowMatrix[x+ft]=Q.getMatrix(ft),i.sunShadowCascade[x+ft]=Q._cascadeData[ft];x+=dt,p++}i.sun[d]=J,d++}else if(U.isDirectionalLight){let J=t.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.directionalShadow[g]=it,i.directionalShadowMap[g]=lt,i.directionalShadowMatrix[g]=U.shadow.matrix,S++}i.directional[g]=J,g++}else if(U.isSpotLight){let J=t.get(U);J.position.setFromMatrixPosition(U.matrixWorld),J.color.copy(G).multiplyScalar(q),J.distance=H,J.coneCos=Math.cos(U.angle),J.penumbraCos=Math.cos(U.angle*(1-U.penumbra)),J.decay=U.decay,i.spot[_]=J;let Q=U.shadow;if(U.map&&(i.spotLightMap[T]=U.map,T++,Q.updateMatrices(U),U.castShadow&&I++),i.spotLightMatrix[_]=Q.matrix,U.castShadow){let it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,i.spotShadow[_]=it,i.spotShadowMap[_]=lt,y++}_++}else if(U.isRectAreaLight){let J=t.get(U);J.color.copy(G).multiplyScalar(q),J.halfWidth.set(U.width*.5,0,0),J.halfHeight.set(0,U.height*.5,0),i.rectArea[w]=J,w++}else if(U.isPointLight){let J=t.get(U);if(J.color.copy(U.color).multiplyScalar(U.intensity),J.distance=U.distance,J.decay=U.decay,U.castShadow){let Q=U.shadow,it=e.get(U);it.shadowIntensity=Q.intensity,it.shadowBias=Q.bias,it.shadowNormalBias=Q.normalBias,it.shadowRadius=Q.radius,it.shadowMapSize=Q.mapSize,it.shadowCameraNear=Q.camera.near,it.shadowCameraFar=Q.camera.far,i.pointShadow[m]=it,i.pointShadowMap[m]=lt,i.pointShadowMatrix[m]=U.shadow.matrix,M++}i.point[m]=J,m++}else if(U.isHemisphereLight){let J=t.get(U);J.skyColor.copy(U.color).multiplyScalar(q),J.groundColor.copy(U.groundColor).multiplyScalar(q),i.hemi[b]=J,b++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Lt.LTC_FLOAT_1,i.rectAreaLTC2=Lt.LTC_FLOAT_2):(i.rectAreaLTC1=Lt.LTC_HALF_1,i.rectAreaLTC2=Lt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;let R=i.hash;(R.sunLength!==d||R.directionalLength!==g||R.pointLength!==m||R.spotLength!==_||R.rectAreaLength!==w||R.hemiLength!==b||R.numSunShadows!==p||R.numDirectionalShadows!==S||R.numPointShadows!==M||R.numSpotShadows!==y||R.numSpotMaps!==T||R.numLightProbes!==P)&&(i.sun.length=d,i.directional.length=g,i.spot.length=_,i.rectArea.length=w,i.point.length=m,i.hemi.length=b,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=S,i.directionalShadowMap.length=S,i.directionalShadowMatrix.length=S,i.pointShadow.length=M,i.pointShadowMap.length=M,i.pointShadowMatrix.length=M,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+T-I,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=I,i.numLightProbes=P,R.sunLength=d,R.directionalLength=g,R.pointLength=m,R.spotLength=_,R.rectAreaLength=w,R.hemiLength=b,R.numSunShadows=p,R.numDirectionalShadows=S,R.numPointShadows=M,R.numSpotShadows=y,R.numSpotMaps=T,R.numLightProbes=P,i.version=mM++)}function l(c,h){let u=0,f=0,d=0,p=0,x=0,g=0,m=h.matrixWorldInverse;for(let _=0,w=c.length;_<w;_++){let b=c[_];if(b.isSunLight){let S=i.sun[u];S.direction.setFromMatrixPosition(b.matrixWorld),S.direction.transformDirection(m),u++}else if(b.isDirectionalLight){let S=i.directional[f];S.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(m),f++}else if(b.isSpotLight){let S=i.spot[p];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(m),S.direction.setFromMatrixPosition(b.matrixWorld),s.setFromMatrixPosition(b.target.matrixWorld),S.direction.sub(s),S.direction.transformDirection(m),p++}else if(b.isRectAreaLight){let S=i.rectArea[x];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(m),o.identity(),r.copy(b.matrixWorld),r.premultiply(m),o.extractRotation(r),S.halfWidth.set(b.width*.5,0,0),S.halfHeight.set(0,b.height*.5,0),S.halfWidth.applyMatrix4(o),S.halfHeight.applyMatrix4(o),x++}else if(b.isPointLight){let S=i.point[d];S.position.setFromMatrixPosition(b.matrixWorld),S.position.applyMatrix4(m),d++}else if(b.isHemisphereLight){let S=i.hemi[g];S.direction.setFromMatrixPosition(b.matrixWorld),S.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function gm(n){let t=new _M(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function xM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new gm(n),t.set(s,[a])):r>=o.length?(a=new gm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var yM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,vM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,bM=[new W(1,0,0),new W(-1,0,0),new W(0,1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1)],SM=[new W(0,-1,0),new W(0,-1,0),new W(0,0,1),new W(0,0,-1),new W(0,-1,0),new W(0,-1,0)],_m=new pe,Ta=new W,Qu=new W;function MM(n,t,e){let i=new Os,s=new Yt,r=new Yt,o=new qe,a=new kl,l=new zl,c={},h=e.maxTextureSize,u={[Hs]:$n,[$n]:Hs,[Bn]:Bn},f=new Xi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Yt},radius:{value:4}},vertexShader:yM,fragmentShader:vM}),d=f.clone();d.defines.HORIZONTAL_PASS=1;let p=new gn;p.setAttribute("position",new sn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Ln(p,f),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=_a;let m=this.type;this.render=function(M,y,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||M.length===0)return;this.type===hp&&(qt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=_a);let I=n.getRenderTarget(),P=n.getActiveCubeFace(),R=n.getActiveMipmapLevel(),F=n.state;F.setBlending(ar),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let z=m!==this.type;z&&y.traverse(function(U){U.material&&(Array.isArray(U.material)?U.material.forEach(G=>G.needsUpdate=!0):U.material.needsUpdate=!0)});for(let U=0,G=M.length;U<G;U++){let q=M[U],H=q.shadow;if(H===void 0){qt("WebGLShadowMap:",q,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let lt=H.getFrameExtents();s.multiply(lt),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/lt.x),s.x=r.x*lt.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/lt.y),s.y=r.y*lt.y,H.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=J,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===ro){if(q.isPointLight){qt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new ai(s.x,s.y,{format:Ws,type:Ri,minFilter:qn,magFilter:qn,generateMipmaps:!1}),H.map.texture.name=q.name+".shadowMap",H.map.depthTexture=new fs(s.x,s.y,_i),H.map.depthTexture.name=q.name+".shadowMapDepth",H.map.depthTexture.format=ls,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Cn,H.map.depthTexture.magFilter=Cn}else q.isPointLight?(H.map=new Ca(s.x),H.map.depthTexture=new ra(s.x,Ci)):(H.map=new ai(s.x,s.y),H.map.depthTexture=new fs(s.x,s.y,Ci)),H.map.depthTexture.name=q.name+".shadowMap",H.map.depthTexture.format=ls,this.type===_a?(H.map.depthTexture.compareFunction=J?zu:ku,H.map.depthTexture.minFilter=qn,H.map.depthTexture.magFilter=qn):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=Cn,H.map.depthTexture.magFilter=Cn);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Q=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();q.isPointLight!==!0&&H.updateMatrices(q,T);let it=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:T.layers;for(let dt=0;dt<Q;dt++){let ft=H.getCamera(dt);if(q.isPointLight){let tt=H.camera,ut=H.matrix,gt=q.distance||tt.far;gt!==tt.far&&(tt.far=gt,tt.updateProjectionMatrix()),Ta.setFromMatrixPosition(q.matrixWorld),tt.position.copy(Ta),Qu.copy(tt.position),Qu.add(bM[dt]),tt.up.copy(SM[dt]),tt.lookAt(Qu),tt.updateMatrixWorld(),ut.makeTranslation(-Ta.x,-Ta.y,-Ta.z),_m.multiplyMatrices(tt.projectionMatrix,tt.matrixWorldInverse),H._frustum.setFromProjectionMatrix(_m,tt.coordinateSystem,tt.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,dt),n.clear();else{dt===0&&(n.setRenderTarget(H.map),n.clear());let tt=H.getViewport(dt);o.set(r.x*tt.x,r.y*tt.y,r.x*tt.z,r.y*tt.w),F.viewport(o)}i=H.getFrustum(dt),b(y,T,ft,q,it,this.type)}H.isPointLightShadow!==!0&&this.type===ro&&_(H,T),H.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(I,P,R)};function _(M,y){let T=t.update(x);f.defines.VSM_SAMPLES!==M.blurSamples&&(f.defines.VSM_SAMPLES=M.blurSamples,d.defines.VSM_SAMPLES=M.blurSamples,f.needsUpdate=!0,d.needsUpdate=!0),M.mapPass===null?M.mapPass=new ai(s.x,s.y,{format:Ws,type:Ri}):(M.mapPass.width!==M.map.width||M.mapPass.height!==M.map.height)&&M.mapPass.setSize(M.map.width,M.map.height),f.uniforms.shadow_pass.value=M.map.depthTexture,f.uniforms.resolution.value.set(M.map.width,M.map.height),f.uniforms.radius.value=M.radius,n.setRenderTarget(M.mapPass),n.clear(),n.renderBufferDirect(y,null,T,f,x,null),d.uniforms.shadow_pass.value=M.mapPass.texture,d.uniforms.resolution.value.set(M.map.width,M.map.height),d.uniforms.radius.value=M.radius,n.setRenderTarget(M.map),n.clear(),n.renderBufferDirect(y,null,T,d,x,null)}function w(M,y,T,I){let P=null,R=T.isPointLight===!0?M.customDistanceMaterial:M.customDepthMaterial;if(R!==void 0)P=R;else if(P=T.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let F=P.uuid,z=y.uuid,U=c[F];U===void 0&&(U={},c[F]=U);let G=U[z];G===void 0&&(G=P.clone(),U[z]=G,y.addEventListener("dispose",S)),P=G}if(P.visible=y.visible,P.wireframe=y.wireframe,I===ro?P.side=y.shadowSide!==null?y.shadowSide:y.side:P.side=y.shadowSide!==null?y.shadowSide:u[y.side],P.alphaMap=y.alphaMap,P.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,P.map=y.map,P.clipShadows=y.clipShadows,P.clippingPlanes=y.clippingPlanes,P.clipIntersection=y.clipIntersection,P.displacementMap=y.displacementMap,P.displacementScale=y.displacementScale,P.displacementBias=y.displacementBias,P.wireframeLinewidth=y.wireframeLinewidth,P.linewidth=y.linewidth,T.isPointLight===!0&&P.isMeshDistanceMaterial===!0){let F=n.properties.get(P);F.light=T}return P}function b(M,y,T,I,P,R){if(M.visible===!1)return;if(M.layers.test(P)&&(M.isMesh||M.isLine||M.isPoints)&&(M.castShadow||M.receiveShadow&&R===ro)&&(!M.frustumCulled||M.intersectsFrustum(i))){M.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,M.matrixWorld);let U=t.update(M),G=M.material;if(Array.isArray(G)){let q=U.groups;for(let H=0,lt=q.length;H<lt;H++){let J=q[H],Q=G[J.materialIndex];if(Q&&Q.visible){let it=w(M,Q,I,R);M.onBeforeShadow(n,M,y,T,U,it,J),n.renderBufferDirect(T,null,U,it,M,J),M.onAfterShadow(n,M,y,T,U,it,J)}}}else if(G.visible){let q=w(M,G,I,R);M.onBeforeShadow(n,M,y,T,U,q,null),n.renderBufferDirect(T,null,U,q,M,null),M.onAfterShadow(n,M,y,T,U,q,null)}}let z=M.children;for(let U=0,G=z.length;U<G;U++)b(z[U],y,T,I,P,R)}function S(M){M.target.removeEventListener("dispose",S);for(let T in c){let I=c[T],P=M.target.uuid;P in I&&(I[P].dispose(),delete I[P])}}}function wM(n,t){function e(){let B=!1,rt=new qe,nt=null,At=new qe(0,0,0,0);return{setMask:function(_t){nt!==_t&&!B&&(n.colorMask(_t,_t,_t,_t),nt=_t)},setLocked:function(_t){B=_t},setClear:function(_t,bt,Gt,Jt,ct){ct===!0&&(_t*=Jt,bt*=Jt,Gt*=Jt),rt.set(_t,bt,Gt,Jt),At.equals(rt)===!1&&(n.clearColor(_t,bt,Gt,Jt),At.copy(rt))},reset:function(){B=!1,nt=null,At.set(-1,0,0,0)}}}function i(){let B=!1,rt=!1,nt=null,At=null,_t=null;return{setReversed:function(bt){if(rt!==bt){let Gt=t.get("EXT_clip_control");bt?Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.ZERO_TO_ONE_EXT):Gt.clipControlEXT(Gt.LOWER_LEFT_EXT,Gt.NEGATIVE_ONE_TO_ONE_EXT),rt=bt;let Jt=_t;_t=null,this.setClear(Jt)}},getReversed:function(){return rt},setTest:function(bt){bt?Mt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(bt){nt!==bt&&!B&&(n.depthMask(bt),nt=bt)},setFunc:function(bt){if(rt&&(bt=Wp[bt]),At!==bt){switch(bt){case bl:n.depthFunc(n.NEVER);break;case Sl:n.depthFunc(n.ALWAYS);break;case Ml:n.depthFunc(n.LESS);break;case Yr:n.depthFunc(n.LEQUAL);break;case wl:n.depthFunc(n.EQUAL);break;case Al:n.depthFunc(n.GEQUAL);break;case Tl:n.depthFunc(n.GREATER);break;case El:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}At=bt}},setLocked:function(bt){B=bt},setClear:function(bt){_t!==bt&&(_t=bt,rt&&(bt=1-bt),n.clearDepth(bt))},reset:function(){B=!1,nt=null,At=null,_t=null,rt=!1}}}function s(){let B=!1,rt=null,nt=null,At=null,_t=null,bt=null,Gt=null,Jt=null,ct=null;return{setTest:function(Ft){B||(Ft?Mt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ft){rt!==Ft&&!B&&(n.stencilMask(Ft),rt=Ft)},setFunc:function(Ft,Kt,Ct){(nt!==Ft||At!==Kt||_t!==Ct)&&(n.stencilFunc(Ft,Kt,Ct),nt=Ft,At=Kt,_t=Ct)},setOp:function(Ft,Kt,Ct){(bt!==Ft||Gt!==Kt||Jt!==Ct)&&(n.stencilOp(Ft,Kt,Ct),bt=Ft,Gt=Kt,Jt=Ct)},setLocked:function(Ft){B=Ft},setClear:function(Ft){ct!==Ft&&(n.clearStencil(Ft),ct=Ft)},reset:function(){B=!1,rt=null,nt=null,At=null,_t=null,bt=null,Gt=null,Jt=null,ct=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},f={},d=new WeakMap,p=[],x=null,g=!1,m=null,_=null,w=null,b=null,S=null,M=null,y=null,T=new Qt(0,0,0),I=0,P=!1,R=null,F=null,z=null,U=null,G=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,lt=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(lt=parseFloat(/^WebGL (\d)/.exec(J)[1]),H=lt>=1):J.indexOf("OpenGL ES")!==-1&&(lt=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),H=lt>=2);let Q=null,it={},dt=n.getParameter(n.SCISSOR_BOX),ft=n.getParameter(n.VIEWPORT),tt=new qe().fromArray(dt),ut=new qe().fromArray(ft);function gt(B,rt,nt,At){let _t=new Uint8Array(4),bt=n.createTexture();n.bindTexture(B,bt),n.texParameteri(B,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(B,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Gt=0;Gt<nt;Gt++)B===n.TEXTURE_3D||B===n.TEXTURE_2D_ARRAY?n.texImage3D(rt,0,n.RGBA,1,1,At,0,n.RGBA,n.UNSIGNED_BYTE,_t):n.texImage2D(rt+Gt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_t);return bt}let St={};St[n.TEXTURE_2D]=gt(n.TEXTURE_2D,n.TEXTURE_2D,1),St[n.TEXTURE_CUBE_MAP]=gt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),St[n.TEXTURE_2D_ARRAY]=gt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),St[n.TEXTURE_3D]=gt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),Mt(n.DEPTH_TEST),o.setFunc(Yr),on(!1),Ie(_u),Mt(n.CULL_FACE),We(ar);function Mt(B){h[B]!==!0&&(n.enable(B),h[B]=!0)}function Ht(B){h[B]!==!1&&(n.disable(B),h[B]=!1)}function se(B,rt){return f[B]!==rt?(n.bindFramebuffer(B,rt),f[B]=rt,B===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=rt),B===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=rt),!0):!1}function Vt(B,rt){let nt=p,At=!1;if(B){nt=d.get(rt),nt===void 0&&(nt=[],d.set(rt,nt));let _t=B.textures;if(nt.length!==_t.length||nt[0]!==n.COLOR_ATTACHMENT0){for(let bt=0,Gt=_t.length;bt<Gt;bt++)nt[bt]=n.COLOR_ATTACHMENT0+bt;nt.length=_t.length,At=!0}}else nt[0]!==n.BACK&&(nt[0]=n.BACK,At=!0);At&&n.drawBuffers(nt)}function he(B){return x!==B?(n.useProgram(B),x=B,!0):!1}let ae={[lr]:n.FUNC_ADD,[fp]:n.FUNC_SUBTRACT,[dp]:n.FUNC_REVERSE_SUBTRACT};ae[pp]=n.MIN,ae[mp]=n.MAX;let ne={[gp]:n.ZERO,[_p]:n.ONE,[xp]:n.SRC_COLOR,[bu]:n.SRC_ALPHA,[wp]:n.SRC_ALPHA_SATURATE,[Sp]:n.DST_COLOR,[vp]:n.DST_ALPHA,[yp]:n.ONE_MINUS_SRC_COLOR,[Su]:n.ONE_MINUS_SRC_ALPHA,[Mp]:n.ONE_MINUS_DST_COLOR,[bp]:n.ONE_MINUS_DST_ALPHA,[Ap]:n.CONSTANT_COLOR,[Tp]:n.ONE_MINUS_CONSTANT_COLOR,[Ep]:n.CONSTANT_ALPHA,[Cp]:n.ONE_MINUS_CONSTANT_ALPHA};function We(B,rt,nt,At,_t,bt,Gt,Jt,ct,Ft){if(B===ar){g===!0&&(Ht(n.BLEND),g=!1);return}if(g===!1&&(Mt(n.BLEND),g=!0),B!==up){if(B!==m||Ft!==P){if((_!==lr||S!==lr)&&(n.blendEquation(n.FUNC_ADD),_=lr,S=lr),Ft)switch(B){case oo:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case xu:n.blendFunc(n.ONE,n.ONE);break;case yu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case vu:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:jt("WebGLState: Invalid blending: ",B);break}else switch(B){case oo:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case xu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case yu:jt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case vu:jt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:jt("WebGLState: Invalid blending: ",B);break}w=null,b=null,M=null,y=null,T.set(0,0,0),I=0,m=B,P=Ft}return}_t=_t||rt,bt=bt||nt,Gt=Gt||At,(rt!==_||_t!==S)&&(n.blendEquationSeparate(ae[rt],ae[_t]),_=rt,S=_t),(nt!==w||At!==b||bt!==M||Gt!==y)&&(n.blendFuncSeparate(ne[nt],ne[At],ne[bt],ne[Gt]),w=nt,b=At,M=bt,y=Gt),(Jt.equals(T)===!1||ct!==I)&&(n.blendColor(Jt.r,Jt.g,Jt.b,ct),T.copy(Jt),I=ct),m=B,P=!1}function Oe(B,rt){B.side===Bn?Ht(n.CULL_FACE):Mt(n.CULL_FACE);let nt=B.side===$n;rt&&(nt=!nt),on(nt),B.blending===oo&&B.transparent===!1?We(ar):We(B.blending,B.blendEquation,B.blendSrc,B.blendDst,B.blendEquationAlpha,B.blendSrcAlpha,B.blendDstAlpha,B.blendColor,B.blendAlpha,B.premultipliedAlpha),o.setFunc(B.depthFunc),o.setTest(B.depthTest),o.setMask(B.depthWrite),r.setMask(B.colorWrite);let At=B.stencilWrite;a.setTest(At),At&&(a.setMask(B.stencilWriteMask),a.setFunc(B.stencilFunc,B.stencilRef,B.stencilFuncMask),a.setOp(B.stencilFail,B.stencilZFail,B.stencilZPass)),ye(B.polygonOffset,B.polygonOffsetFactor,B.polygonOffsetUnits),B.alphaToCoverage===!0?Mt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function on(B){R!==B&&(B?n.frontFace(n.CW):n.frontFace(n.CCW),R=B)}function Ie(B){B!==lp?(Mt(n.CULL_FACE),B!==F&&(B===_u?n.cullFace(n.BACK):B===cp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),F=B}function Sn(B){B!==z&&(H&&n.lineWidth(B),z=B)}function ye(B,rt,nt){B?(Mt(n.POLYGON_OFFSET_FILL),(U!==rt||G!==nt)&&(U=rt,G=nt,o.getReversed()&&(rt=-rt,nt=-nt),n.polygonOffset(rt,nt))):Ht(n.POLYGON_OFFSET_FILL)}function pn(B){B?Mt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Ye(B){B===void 0&&(B=n.TEXTURE0+q-1),Q!==B&&(n.activeTexture(B),Q=B)}function an(B,rt,nt){nt===void 0&&(Q===null?nt=n.TEXTURE0+q-1:nt=Q);let At=it[nt];At===void 0&&(At={type:void 0,texture:void 0},it[nt]=At),(At.type!==B||At.texture!==rt)&&(Q!==nt&&(n.activeTexture(nt),Q=nt),n.bindTexture(B,rt||St[B]),At.type=B,At.texture=rt)}function k(){let B=it[Q];B!==void 0&&B.type!==void 0&&(n.bindTexture(B.type,null),B.type=void 0,B.texture=void 0)}function Rt(){try{n.compressedTexImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function $t(){try{n.compressedTexImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function re(){try{n.texSubImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function wt(){try{n.texSubImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function Ne(){try{n.compressedTexSubImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function zt(){try{n.compressedTexSubImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function Xt(){try{n.texStorage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function L(){try{n.texStorage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function A(){try{n.texImage2D(...arguments)}catch(B){jt("WebGLState:",B)}}function $(){try{n.texImage3D(...arguments)}catch(B){jt("WebGLState:",B)}}function ht(B){return u[B]!==void 0?u[B]:n.getParameter(B)}function ot(B,rt){u[B]!==rt&&(n.pixelStorei(B,rt),u[B]=rt)}function xt(B){tt.equals(B)===!1&&(n.scissor(B.x,B.y,B.z,B.w),tt.copy(B))}function yt(B){ut.equals(B)===!1&&(n.viewport(B.x,B.y,B.z,B.w),ut.copy(B))}function et(B,rt){let nt=c.get(rt);nt===void 0&&(nt=new WeakMap,c.set(rt,nt));let At=nt.get(B);At===void 0&&(At=n.getUniformBlockIndex(rt,B.name),n.uniformBlockBinding(rt,At,At),nt.set(B,At))}function st(B,rt,nt){let _t=c.get(rt).get(B);l[_t]!==nt&&(n.bindBufferBase(n.UNIFORM_BUFFER,_t,nt),l[_t]=nt)}function mt(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,it={},f={},l={},d=new WeakMap,p=[],x=null,g=!1,m=null,_=null,w=null,b=null,S=null,M=null,y=null,T=new Qt(0,0,0),I=0,P=!1,R=null,F=null,z=null,U=null,G=null,tt.set(0,0,n.canvas.width,n.canvas.height),ut.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:Mt,disable:Ht,bindFramebuffer:se,drawBuffers:Vt,useProgram:he,setBlending:We,setMaterial:Oe,setFlipSided:on,setCullFace:Ie,setLineWidth:Sn,setPolygonOffset:ye,setScissorTest:pn,activeTexture:Ye,bindTexture:an,unbindTexture:k,compressedTexImage2D:Rt,compressedTexImage3D:$t,texImage2D:A,texImage3D:$,pixelStorei:ot,getParameter:ht,updateUBOMapping:et,uniformBlockBinding:st,texStorage2D:Xt,texStorage3D:L,texSubImage2D:re,texSubImage3D:wt,compressedTexSubImage2D:Ne,compressedTexSubImage3D:zt,scissor:xt,viewport:yt,reset:mt}}function AM(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Yt,h=new WeakMap,u=new Set,f,d=new WeakMap,p=new Set,x=new FinalizationRegistry(L=>p.delete(L)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(L,A){return g?new OffscreenCanvas(L,A):Ko("canvas")}function _(L,A,$){let ht=1,ot=Xt(L);if((ot.width>$||ot.height>$)&&(ht=$/Math.max(ot.width,ot.height)),ht<1)if(typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&L instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&L instanceof ImageBitmap||typeof VideoFrame<"u"&&L instanceof VideoFrame){let xt=Math.floor(ht*ot.width),yt=Math.floor(ht*ot.height);f===void 0&&(f=m(xt,yt));let et=A?m(xt,yt):f;return et.width=xt,et.height=yt,et.getContext("2d").drawImage(L,0,0,xt,yt),qt("WebGLRenderer: Texture has been resized from ("+ot.width+"x"+ot.height+") to ("+xt+"x"+yt+")."),et}else return"data"in L&&qt("WebGLRenderer: Image in DataTexture is too big ("+ot.width+"x"+ot.height+")."),L;return L}function w(L){return L.generateMipmaps}function b(L){n.generateMipmap(L)}function S(L){return L.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:L.isWebGL3DRenderTarget?n.TEXTURE_3D:L.isWebGLArrayRenderTarget||L.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function M(L,A,$,ht,ot,xt=!1){if(L!==null){if(n[L]!==void 0)return n[L];qt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+L+"'")}let yt;ht&&(yt=t.get("EXT_texture_norm16"),yt||qt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let et=A;if(A===n.RED&&($===n.FLOAT&&(et=n.R32F),$===n.HALF_FLOAT&&(et=n.R16F),$===n.UNSIGNED_BYTE&&(et=n.R8),$===n.UNSIGNED_SHORT&&yt&&(et=yt.R16_EXT),$===n.SHORT&&yt&&(et=yt.R16_SNORM_EXT)),A===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.R8UI),$===n.UNSIGNED_SHORT&&(et=n.R16UI),$===n.UNSIGNED_INT&&(et=n.R32UI),$===n.BYTE&&(et=n.R8I),$===n.SHORT&&(et=n.R16I),$===n.INT&&(et=n.R32I)),A===n.RG&&($===n.FLOAT&&(et=n.RG32F),$===n.HALF_FLOAT&&(et=n.RG16F),$===n.UNSIGNED_BYTE&&(et=n.RG8),$===n.UNSIGNED_SHORT&&yt&&(et=yt.RG16_EXT),$===n.SHORT&&yt&&(et=yt.RG16_SNORM_EXT)),A===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RG8UI),$===n.UNSIGNED_SHORT&&(et=n.RG16UI),$===n.UNSIGNED_INT&&(et=n.RG32UI),$===n.BYTE&&(et=n.RG8I),$===n.SHORT&&(et=n.RG16I),$===n.INT&&(et=n.RG32I)),A===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RGB8UI),$===n.UNSIGNED_SHORT&&(et=n.RGB16UI),$===n.UNSIGNED_INT&&(et=n.RGB32UI),$===n.BYTE&&(et=n.RGB8I),$===n.SHORT&&(et=n.RGB16I),$===n.INT&&(et=n.RGB32I)),A===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(et=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(et=n.RGBA16UI),$===n.UNSIGNED_INT&&(et=n.RGBA32UI),$===n.BYTE&&(et=n.RGBA8I),$===n.SHORT&&(et=n.RGBA16I),$===n.INT&&(et=n.RGBA32I)),A===n.RGB&&($===n.UNSIGNED_SHORT&&yt&&(et=yt.RGB16_EXT),$===n.SHORT&&yt&&(et=yt.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(et=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(et=n.R11F_G11F_B10F)),A===n.RGBA){let st=xt?Jo:_e.getTransfer(ot);$===n.FLOAT&&(et=n.RGBA32F),$===n.HALF_FLOAT&&(et=n.RGBA16F),$===n.UNSIGNED_BYTE&&(et=st===Ae?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&yt&&(et=yt.RGBA16_EXT),$===n.SHORT&&yt&&(et=yt.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(et=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(et=n.RGB5_A1)}return(et===n.R16F||et===n.R32F||et===n.RG16F||et===n.RG32F||et===n.RGBA16F||et===n.RGBA32F)&&t.get("EXT_color_buffer_float"),et}function y(L,A){let $;return L?A===null||A===Ci||A===hr?$=n.DEPTH24_STENCIL8:A===_i?$=n.DEPTH32F_STENCIL8:A===lo&&($=n.DEPTH24_STENCIL8,qt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):A===null||A===Ci||A===hr?$=n.DEPTH_COMPONENT24:A===_i?$=n.DEPTH_COMPONENT32F:A===lo&&($=n.DEPTH_COMPONENT16),$}function T(L,A){return w(L)===!0||L.isFramebufferTexture&&L.minFilter!==Cn&&L.minFilter!==qn?Math.log2(Math.max(A.width,A.height))+1:L.mipmaps.length>0?L.mipmaps.length:L.isCompressedTexture&&Array.isArray(L.image)?A.mipmaps.length:1}function I(L){let A=new WeakRef(L);i.get(L).__ref=A,p.add(A),x.register(L,A,A)}function P(L){let A=i.get(L).__ref;A!==void 0&&(p.delete(A),x.unregister(A))}function R(L){z(L.target)}function F(L){U(L.target)}function z(L){L.removeEventListener("dispose",R),P(L),q(L),L.isVideoTexture&&h.delete(L),L.isHTMLTexture&&u.delete(L)}function U(L){L.removeEventListener("dispose",F),P(L),lt(L)}function G(){for(let L of p){let A=L.deref();A!==void 0&&(A.isRenderTarget===!0?U(A):z(A))}p.clear(),u.clear()}function q(L){let A=i.get(L);if(A.__webglInit===void 0)return;let $=L.source,ht=d.get($);if(ht){let ot=ht[A.__cacheKey];ot.usedTimes--,ot.usedTimes===0&&H(L),Object.keys(ht).length===0&&d.delete($)}i.remove(L)}function H(L){let A=i.get(L);n.deleteTexture(A.__webglTexture);let $=L.source,ht=d.get($);delete ht[A.__cacheKey],o.memory.textures--}function lt(L){let A=i.get(L);A.__depthDisposeCallback&&A.__depthDisposeCallback();let $=L.depthTexture;if($&&$.renderTarget===L&&z($),L.isWebGLCubeRenderTarget)for(let ot=0;ot<6;ot++){if(Array.isArray(A.__webglFramebuffer[ot]))for(let xt=0;xt<A.__webglFramebuffer[ot].length;xt++)n.deleteFramebuffer(A.__webglFramebuffer[ot][xt]);else n.deleteFramebuffer(A.__webglFramebuffer[ot]);A.__webglDepthbuffer&&n.deleteRenderbuffer(A.__webglDepthbuffer[ot])}else{if(Array.isArray(A.__webglFramebuffer))for(let ot=0;ot<A.__webglFramebuffer.length;ot++)n.deleteFramebuffer(A.__webglFramebuffer[ot]);else n.deleteFramebuffer(A.__webglFramebuffer);if(A.__webglDepthbuffer&&n.deleteRenderbuffer(A.__webglDepthbuffer),A.__webglMultisampledFramebuffer&&n.deleteFramebuffer(A.__webglMultisampledFramebuffer),A.__webglColorRenderbuffer)for(let ot=0;ot<A.__webglColorRenderbuffer.length;ot++)A.__webglColorRenderbuffer[ot]&&n.deleteRenderbuffer(A.__webglColorRenderbuffer[ot]);A.__webglDepthRenderbuffer&&n.deleteRenderbuffer(A.__webglDepthRenderbuffer)}let ht=L.textures;for(let ot=0,xt=ht.length;ot<xt;ot++){let yt=i.get(ht[ot]);yt.__webglTexture&&(n.deleteTexture(yt.__webglTexture),o.memory.textures--),i.remove(ht[ot])}i.remove(L)}let J=0;function Q(){J=0}function it(){return J}function dt(L){J=L}function ft(){let L=J;return L>=s.maxTextures&&qt("WebGLTextures: Trying to use "+(L+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,L}function tt(L){let A=[];return A.push(L.wrapS),A.push(L.wrapT),A.push(L.wrapR||0),A.push(L.magFilter),A.push(L.minFilter),A.push(L.anisotropy),A.push(L.internalFormat),A.push(L.format),A.push(L.type),A.push(L.generateMipmaps),A.push(L.mipmapsAutoUpdate),A.push(L.premultiplyAlpha),A.push(L.flipY),A.push(L.unpackAlignment),A.push(L.colorSpace),A.join()}function ut(L,A){let $=i.get(L);if(L.isVideoTexture&&Ne(L),L.isRenderTargetTexture===!1&&L.isExternalTexture!==!0&&L.version>0&&$.__version!==L.version){let ht=L.image;if(ht===null)qt("WebGLRenderer: Texture marked for update but no image data found.");else if(ht.complete===!1)qt("WebGLRenderer: Texture marked for update but image is incomplete");else{Oe($,L,A);return}}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+A)}function gt(L,A){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Oe($,L,A);return}else L.isExternalTexture&&($.__webglTexture=L.sourceTexture?L.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+A)}function St(L,A){let $=i.get(L);if(L.isRenderTargetTexture===!1&&L.version>0&&$.__version!==L.version){Oe($,L,A);return}e.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+A)}function Mt(L,A){let $=i.get(L);if(L.version>0&&$.__version!==L.version){on($,L,A);return}e.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+A)}let Ht={[Cl]:n.REPEAT,[Gi]:n.CLAMP_TO_EDGE,[Rl]:n.MIRRORED_REPEAT},se={[Cn]:n.NEAREST,[Ip]:n.NEAREST_MIPMAP_NEAREST,[xa]:n.NEAREST_MIPMAP_LINEAR,[qn]:n.LINEAR,[nc]:n.LINEAR_MIPMAP_NEAREST,[ps]:n.LINEAR_MIPMAP_LINEAR},Vt={[Up]:n.NEVER,[Vu]:n.ALWAYS,[Op]:n.LESS,[ku]:n.LEQUAL,[Fp]:n.EQUAL,[zu]:n.GEQUAL,[Bp]:n.GREATER,[kp]:n.NOTEQUAL};function he(L,A){if(A.type===_i&&t.has("OES_texture_float_linear")===!1&&(A.magFilter===qn||A.magFilter===nc||A.magFilter===xa||A.magFilter===ps||A.minFilter===qn||A.minFilter===nc||A.minFilter===xa||A.minFilter===ps)&&qt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(L,n.TEXTURE_WRAP_S,Ht[A.wrapS]),n.texParameteri(L,n.TEXTURE_WRAP_T,Ht[A.wrapT]),(L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY)&&n.texParameteri(L,n.TEXTURE_WRAP_R,Ht[A.wrapR]),n.texParameteri(L,n.TEXTURE_MAG_FILTER,se[A.magFilter]),n.texParameteri(L,n.TEXTURE_MIN_FILTER,se[A.minFilter]),A.compareFunction&&(n.texParameteri(L,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(L,n.TEXTURE_COMPARE_FUNC,Vt[A.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(A.magFilter===Cn||A.minFilter!==xa&&A.minFilter!==ps||A.type===_i&&t.has("OES_texture_float_linear")===!1)return;if(A.anisotropy>1||i.get(A).__currentAnisotropy){let $=t.get("EXT_texture_filter_anisotropic");n.texParameterf(L,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(A.anisotropy,s.getMaxAnisotropy())),i.get(A).__currentAnisotropy=A.anisotropy}}}function ae(L,A){let $=!1;L.__webglInit===void 0&&(L.__webglInit=!0,A.addEventListener("dispose",R),I(A));let ht=A.source,ot=d.get(ht);ot===void 0&&(ot={},d.set(ht,ot));let xt=tt(A);if(xt!==L.__cacheKey){ot[xt]===void 0&&(ot[xt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ot[xt].usedTimes++;let yt=ot[L.__cacheKey];yt!==void 0&&(ot[L.__cacheKey].usedTimes--,yt.usedTimes===0&&H(A)),L.__cacheKey=xt,L.__webglTexture=ot[xt].texture}return $}function ne(L,A,$){return Math.floor(Math.floor(L/$)/A)}function We(L,A,$,ht){let xt=L.updateRanges;if(xt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,A.width,A.height,$,ht,A.data);else{xt.sort((B,rt)=>B.start-rt.start);let yt=0;for(let B=1;B<xt.length;B++){let rt=xt[yt],nt=xt[B],At=rt.start+rt.count,_t=ne(nt.start,A.width,4),bt=ne(rt.start,A.width,4);nt.start<=At+1&&_t===bt&&ne(nt.start+nt.count-1,A.width,4)===_t?rt.count=Math.max(rt.count,nt.start+nt.count-rt.start):(++yt,xt[yt]=nt)}xt.length=yt+1;let et=e.getParameter(n.UNPACK_ROW_LENGTH),st=e.getParameter(n.UNPACK_SKIP_PIXELS),mt=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,A.width);for(let B=0,rt=xt.length;B<rt;B++){let nt=xt[B],At=Math.floor(nt.start/4),_t=Math.ceil(nt.count/4),bt=At%A.width,Gt=Math.floor(At/A.width),Jt=_t,ct=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,bt),e.pixelStorei(n.UNPACK_SKIP_ROWS,Gt),e.texSubImage2D(n.TEXTURE_2D,0,bt,Gt,Jt,ct,$,ht,A.data)}L.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,et),e.pixelStorei(n.UNPACK_SKIP_PIXELS,st),e.pixelStorei(n.UNPACK_SKIP_ROWS,mt)}}function Oe(L,A,$){let ht=n.TEXTURE_2D;(A.isDataArrayTexture||A.isCompressedArrayTexture)&&(ht=n.TEXTURE_2D_ARRAY),A.isData3DTexture&&(ht=n.TEXTURE_3D);let ot=ae(L,A),xt=A.source;e.bindTexture(ht,L.__webglTexture,n.TEXTURE0+$);let yt=i.get(xt);if(xt.version!==yt.__version||ot===!0){if(e.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&A.image instanceof ImageBitmap)===!1){let ct=_e.getPrimaries(_e.workingColorSpace),Ft=A.colorSpace===gs?null:_e.getPrimaries(A.colorSpace),Kt=A.colorSpace===gs||ct===Ft?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,A.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Kt)}e.pixelStorei(n.UNPACK_ALIGNMENT,A.unpackAlignment);let st=_(A.image,!1,s.maxTextureSize);st=zt(A,st);let mt=r.convert(A.format,A.colorSpace),B=r.convert(A.type),rt=M(A.internalFormat,mt,B,A.normalized,A.colorSpace,A.isVideoTexture);he(ht,A);let nt,At=A.mipmaps,_t=A.isVideoTexture!==!0,bt=yt.__version===void 0||ot===!0,Gt=xt.dataReady,Jt=T(A,st);if(A.isDepthTexture)rt=y(A.format===ms,A.type),bt&&(_t?e.texStorage2D(n.TEXTURE_2D,1,rt,st.width,st.height):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,B,null));else if(A.isDataTexture)if(At.length>0){_t&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,B,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,B,nt.data);A.generateMipmaps=!1}else _t?(bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,st.width,st.height),Gt&&We(A,st,mt,B)):e.texImage2D(n.TEXTURE_2D,0,rt,st.width,st.height,0,mt,B,st.data);else if(A.isCompressedTexture)if(A.isCompressedArrayTexture){_t&&bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,rt,At[0].width,At[0].height,st.depth);for(let ct=0,Ft=At.length;ct<Ft;ct++)if(nt=At[ct],A.format!==Pi)if(mt!==null)if(_t){if(Gt)if(A.layerUpdates.size>0){let Kt=Ku(nt.width,nt.height,A.format,A.type);for(let Ct of A.layerUpdates){let oe=nt.data.subarray(Ct*Kt/nt.data.BYTES_PER_ELEMENT,(Ct+1)*Kt/nt.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,Ct,nt.width,nt.height,1,mt,oe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,nt.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,nt.data,0,0);else qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _t?Gt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,ct,0,0,0,nt.width,nt.height,st.depth,mt,B,nt.data):e.texImage3D(n.TEXTURE_2D_ARRAY,ct,rt,nt.width,nt.height,st.depth,0,mt,B,nt.data);A.layerUpdates.size>0&&A.clearLayerUpdates()}else{_t&&bt&&e.texStorage2D(n.TEXTURE_2D,Jt,rt,At[0].width,At[0].height);for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],A.format!==Pi?mt!==null?_t?Gt&&e.compressedTexSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,nt.data):e.compressedTexImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,nt.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,nt.width,nt.height,mt,B,nt.data):e.texImage2D(n.TEXTURE_2D,ct,rt,nt.width,nt.height,0,mt,B,nt.data)}else if(A.isDataArrayTexture)if(_t){if(bt&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Jt,rt,st.width,st.height,st.depth),Gt)if(A.layerUpdates.size>0){let ct=Ku(st.width,st.height,A.format,A.type);for(let Ft of A.layerUpdates){let Kt=st.data.subarray(Ft*ct/st.data.BYTES_PER_ELEMENT,(Ft+1)*ct/st.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ft,st.width,st.height,1,mt,B,Kt)}A.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,rt,st.width,st.height,st.depth,0,mt,B,st.data);else if(A.isData3DTexture)_t?(bt&&e.texStorage3D(n.TEXTURE_3D,Jt,rt,st.width,st.height,st.depth),Gt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,st.width,st.height,st.depth,mt,B,st.data)):e.texImage3D(n.TEXTURE_3D,0,rt,st.width,st.height,st.depth,0,mt,B,st.data);else if(A.isFramebufferTexture){if(bt)if(_t)e.texStorage2D(n.TEXTURE_2D,Jt,rt,st.width,st.height);else{let ct=st.width,Ft=st.height;for(let Kt=0;Kt<Jt;Kt++)e.texImage2D(n.TEXTURE_2D,Kt,rt,ct,Ft,0,mt,B,null),ct>>=1,Ft>>=1}}else if(A.isHTMLTexture){if("texElementImage2D"in n){let ct=n.canvas;if(ct.hasAttribute("layoutsubtree")||ct.setAttribute("layoutsubtree","true"),st.parentNode!==ct){ct.appendChild(st),u.add(A),ct.onpaint=Ft=>{let Kt=Ft.changedElements;for(let Ct of u)Kt.includes(Ct.image)&&(Ct.needsUpdate=!0)},ct.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,st);else{let Kt=n.RGBA,Ct=n.RGBA,oe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Kt,Ct,oe,st)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(At.length>0){if(_t&&bt){let ct=Xt(At[0]);e.texStorage2D(n.TEXTURE_2D,Jt,rt,ct.width,ct.height)}for(let ct=0,Ft=At.length;ct<Ft;ct++)nt=At[ct],_t?Gt&&e.texSubImage2D(n.TEXTURE_2D,ct,0,0,mt,B,nt):e.texImage2D(n.TEXTURE_2D,ct,rt,mt,B,nt);A.generateMipmaps=!1}else if(_t){if(bt){let ct=Xt(st);e.texStorage2D(n.TEXTURE_2D,Jt,rt,ct.width,ct.height)}Gt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,mt,B,st)}else e.texImage2D(n.TEXTURE_2D,0,rt,mt,B,st);w(A)&&A.mipmapsAutoUpdate===!0&&b(ht),yt.__version=xt.version,A.onUpdate&&A.onUpdate(A)}L.__version=A.version}function on(L,A,$){if(A.image.length!==6)return;let ht=ae(L,A),ot=A.source;e.bindTexture(n.TEXTURE_CUBE_MAP,L.__webglTexture,n.TEXTURE0+$);let xt=i.get(ot);if(ot.version!==xt.__version||ht===!0){e.activeTexture(n.TEXTURE0+$);let yt=_e.getPrimaries(_e.workingColorSpace),et=A.colorSpace===gs?null:_e.getPrimaries(A.colorSpace),st=A.colorSpace===gs||yt===et?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,A.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,A.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,A.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,st);let mt=A.isCompressedTexture||A.image[0].isCompressedTexture,B=A.image[0]&&A.image[0].isDataTexture,rt=[];for(let Ct=0;Ct<6;Ct++)!mt&&!B?rt[Ct]=_(A.image[Ct],!0,s.maxCubemapSize):rt[Ct]=B?A.image[Ct].image:A.image[Ct],rt[Ct]=zt(A,rt[Ct]);let nt=rt[0],At=r.convert(A.format,A.colorSpace),_t=r.convert(A.type),bt=M(A.internalFormat,At,_t,A.normalized,A.colorSpace),Gt=A.isVideoTexture!==!0,Jt=xt.__version===void 0||ht===!0,ct=ot.dataReady,Ft=T(A,nt);he(n.TEXTURE_CUBE_MAP,A);let Kt;if(A.isDepthTexture){if(bt=y(A.format===ms,A.type),Jt)if(Gt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,bt,nt.width,nt.height);else for(let Ct=0;Ct<6;Ct++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,nt.width,nt.height,0,At,_t,null)}else if(mt){Gt&&Jt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,nt.width,nt.height);for(let Ct=0;Ct<6;Ct++){Kt=rt[Ct].mipmaps;for(let oe=0;oe<Kt.length;oe++){let Be=Kt[oe];A.format!==Pi?At!==null?Gt?ct&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Be.width,Be.height,At,Be.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Be.width,Be.height,0,Be.data):qt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,0,0,Be.width,Be.height,At,_t,Be.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe,bt,Be.width,Be.height,0,At,_t,Be.data)}}}else{if(Kt=A.mipmaps,Gt&&Jt){Kt.length>0&&Ft++;let Ct=Xt(rt[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,bt,Ct.width,Ct.height)}for(let Ct=0;Ct<6;Ct++)if(B){Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,rt[Ct].width,rt[Ct].height,At,_t,rt[Ct].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,rt[Ct].width,rt[Ct].height,0,At,_t,rt[Ct].data);for(let oe=0;oe<Kt.length;oe++){let zn=Kt[oe].image[Ct].image;Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,zn.width,zn.height,At,_t,zn.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,zn.width,zn.height,0,At,_t,zn.data)}}else{Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,0,0,At,_t,rt[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,0,bt,At,_t,rt[Ct]);for(let oe=0;oe<Kt.length;oe++){let Be=Kt[oe];Gt?ct&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,0,0,At,_t,Be.image[Ct]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ct,oe+1,bt,At,_t,Be.image[Ct])}}}w(A)&&A.mipmapsAutoUpdate===!0&&b(n.TEXTURE_CUBE_MAP),xt.__version=ot.version,A.onUpdate&&A.onUpdate(A)}L.__version=A.version}function Ie(L,A,$,ht,ot,xt){let yt=r.convert($.format,$.colorSpace),et=r.convert($.type),st=M($.internalFormat,yt,et,$.normalized,$.colorSpace),mt=i.get(A),B=i.get($);if(B.__renderTarget=A,!mt.__hasExternalTextures){let rt=Math.max(1,A.width>>xt),nt=Math.max(1,A.height>>xt);ot===n.TEXTURE_3D||ot===n.TEXTURE_2D_ARRAY?e.texImage3D(ot,xt,st,rt,nt,A.depth,0,yt,et,null):e.texImage2D(ot,xt,st,rt,nt,0,yt,et,null)}e.bindFramebuffer(n.FRAMEBUFFER,L),wt(A)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ht,ot,B.__webglTexture,0,re(A)):(ot===n.TEXTURE_2D||ot>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ot<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ht,ot,B.__webglTexture,xt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Sn(L,A,$){if(n.bindRenderbuffer(n.RENDERBUFFER,L),A.depthBuffer){let ht=A.depthTexture,ot=ht&&ht.isDepthTexture?ht.type:null,xt=y(A.stencilBuffer,ot),yt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;wt(A)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(A),xt,A.width,A.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(A),xt,A.width,A.height):n.renderbufferStorage(n.RENDERBUFFER,xt,A.width,A.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,yt,n.RENDERBUFFER,L)}else{let ht=A.textures;for(let ot=0;ot<ht.length;ot++){let xt=ht[ot],yt=r.convert(xt.format,xt.colorSpace),et=r.convert(xt.type),st=M(xt.internalFormat,yt,et,xt.normalized,xt.colorSpace);wt(A)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,re(A),st,A.width,A.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,re(A),st,A.width,A.height):n.renderbufferStorage(n.RENDERBUFFER,st,A.width,A.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function ye(L,A,$){let ht=A.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,L),!(A.depthTexture&&A.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ot=i.get(A.depthTexture);ot.__renderTarget=A;let xt=ht?A.depthTexture.image[0]:A.depthTexture.image;(!ot.__webglTexture||xt.width!==A.width||xt.height!==A.height)&&(xt.width=A.width,xt.height=A.height,A.depthTexture.needsUpdate=!0),ht?Mt(A.depthTexture,0):ut(A.depthTexture,0);let yt=ot.__webglTexture,et=re(A),st=ht?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,mt=A.depthTexture.format===ms?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(A.depthTexture.format===ls)wt(A)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else if(A.depthTexture.format===ms)wt(A)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,mt,st,yt,0,et):n.framebufferTexture2D(n.FRAMEBUFFER,mt,st,yt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function pn(L){let A=i.get(L),$=L.isWebGLCubeRenderTarget===!0;if(A.__boundDepthTexture!==L.depthTexture){let ht=L.depthTexture;if(A.__depthDisposeCallback&&A.__depthDisposeCallback(),ht){let ot=()=>{delete A.__boundDepthTexture,delete A.__depthDisposeCallback,ht.removeEventListener("dispose",ot)};ht.addEventListener("dispose",ot),A.__depthDisposeCallback=ot}A.__boundDepthTexture=ht}if(L.depthTexture&&!A.__autoAllocateDepthBuffer)if($)for(let ht=0;ht<6;ht++)ye(A.__webglFramebuffer[ht],L,ht);else L.texture.mipmaps.length>0?ye(A.__webglFramebuffer[0],L,0):ye(A.__webglFramebuffer,L,0);else if($){A.__webglDepthbuffer=[];for(let ht=0;ht<6;ht++)if(e.bindFramebuffer(n.FRAMEBUFFER,A.__webglFramebuffer[ht]),A.__webglDepthbuffer[ht]===void 0)A.__webglDepthbuffer[ht]=n.createRenderbuffer(),Sn(A.__webglDepthbuffer[ht],L,!1);else{let ot=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=A.__webglDepthbuffer[ht];n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}}else if(L.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,A.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,A.__webglFramebuffer),A.__webglDepthbuffer===void 0)A.__webglDepthbuffer=n.createRenderbuffer(),Sn(A.__webglDepthbuffer,L,!1);else{let ot=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xt=A.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xt),n.framebufferRenderbuffer(n.FRAMEBUFFER,ot,n.RENDERBUFFER,xt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Ye(L,A,$){let ht=i.get(L);A!==void 0&&Ie(ht.__webglFramebuffer,L,L.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&pn(L)}function an(L){let A=L.texture,$=i.get(L),ht=i.get(A);L.addEventListener("dispose",F),I(L);let ot=L.textures,xt=L.isWebGLCubeRenderTarget===!0,yt=ot.length>1;if(yt||(ht.__webglTexture===void 0&&(ht.__webglTexture=n.createTexture()),ht.__version=A.version,o.memory.textures++),xt){$.__webglFramebuffer=[];for(let et=0;et<6;et++)if(A.mipmaps.length>0){$.__webglFramebuffer[et]=[];for(let st=0;st<A.mipmaps.length;st++)$.__webglFramebuffer[et][st]=n.createFramebuffer()}else $.__webglFramebuffer[et]=n.createFramebuffer()}else{if(A.mipmaps.length>0){$.__webglFramebuffer=[];for(let et=0;et<A.mipmaps.length;et++)$.__webglFramebuffer[et]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(yt)for(let et=0,st=ot.length;et<st;et++){let mt=i.get(ot[et]);mt.__webglTexture===void 0&&(mt.__webglTexture=n.createTexture(),o.memory.textures++)}if(L.samples>0&&wt(L)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let et=0;et<ot.length;et++){let st=ot[et];$.__webglColorRenderbuffer[et]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[et]);let mt=r.convert(st.format,st.colorSpace),B=r.convert(st.type),rt=M(st.internalFormat,mt,B,st.normalized,st.colorSpace,L.isXRRenderTarget===!0),nt=re(L);n.renderbufferStorageMultisample(n.RENDERBUFFER,nt,rt,L.width,L.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+et,n.RENDERBUFFER,$.__webglColorRenderbuffer[et])}n.bindRenderbuffer(n.RENDERBUFFER,null),L.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),Sn($.__webglDepthRenderbuffer,L,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xt){e.bindTexture(n.TEXTURE_CUBE_MAP,ht.__webglTexture),he(n.TEXTURE_CUBE_MAP,A);for(let et=0;et<6;et++)if(A.mipmaps.length>0)for(let st=0;st<A.mipmaps.length;st++)Ie($.__webglFramebuffer[et][st],L,A,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,st);else Ie($.__webglFramebuffer[et],L,A,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+et,0);w(A)?b(n.TEXTURE_CUBE_MAP):A.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),e.unbindTexture()}else if(yt){for(let et=0,st=ot.length;et<st;et++){let mt=ot[et],B=i.get(mt),rt=n.TEXTURE_2D;(L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(rt=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(rt,B.__webglTexture),he(rt,mt),Ie($.__webglFramebuffer,L,mt,n.COLOR_ATTACHMENT0+et,rt,0),w(mt)&&b(rt)}e.unbindTexture()}else{let et=n.TEXTURE_2D;if((L.isWebGL3DRenderTarget||L.isWebGLArrayRenderTarget)&&(et=L.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(et,ht.__webglTexture),he(et,A),A.mipmaps.length>0)for(let st=0;st<A.mipmaps.length;st++)Ie($.__webglFramebuffer[st],L,A,n.COLOR_ATTACHMENT0,et,st);else Ie($.__webglFramebuffer,L,A,n.COLOR_ATTACHMENT0,et,0);w(A)?b(et):A.mipmaps.length>0&&n.texParameteri(et,n.TEXTURE_MAX_LEVEL,A.mipmaps.length-1),e.unbindTexture()}L.depthBuffer&&pn(L)}function k(L){let A=L.textures;for(let $=0,ht=A.length;$<ht;$++){let ot=A[$];if(w(ot)&&ot.mipmapsAutoUpdate===!0){let xt=S(L),yt=i.get(ot).__webglTexture;e.bindTexture(xt,yt),b(xt),e.unbindTexture()}}}let Rt=[];function $t(L){if(L.samples>0){if(wt(L)===!1){let A=L.textures,$=L.width,ht=L.height,ot=n.COLOR_BUFFER_BIT,xt=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,yt=i.get(L),et=A.length>1;if(et)for(let mt=0;mt<A.length;mt++)e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,yt.__webglMultisampledFramebuffer),L.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglFramebuffer);for(let mt=0;mt<A.length;mt++){if(L.resolveDepthBuffer&&(L.depthBuffer&&(ot|=n.DEPTH_BUFFER_BIT),L.stencilBuffer&&L.resolveStencilBuffer&&(ot|=n.STENCIL_BUFFER_BIT)),et){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let B=i.get(A[mt]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,B,0)}n.blitFramebuffer(0,0,$,ht,0,0,$,ht,ot,n.NEAREST),l===!0&&(Rt.length=0,Rt.push(n.COLOR_ATTACHMENT0+mt),L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&Rt.push(xt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Rt))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),et)for(let mt=0;mt<A.length;mt++){e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.RENDERBUFFER,yt.__webglColorRenderbuffer[mt]);let B=i.get(A[mt]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,yt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+mt,n.TEXTURE_2D,B,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,yt.__webglMultisampledFramebuffer)}else if(L.depthBuffer&&L.storeMultisampledDepthBuffer===!1&&l){let A=L.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[A])}}}function re(L){return Math.min(s.maxSamples,L.samples)}function wt(L){let A=i.get(L);return L.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&A.__useRenderToTexture!==!1}function Ne(L){let A=o.render.frame;h.get(L)!==A&&(h.set(L,A),L.update())}function zt(L,A){let $=L.colorSpace,ht=L.format,ot=L.type;return L.isCompressedTexture===!0||L.isVideoTexture===!0||$!==Zo&&$!==gs&&(_e.getTransfer($)===Ae?(ht!==Pi||ot!==Jn)&&qt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):jt("WebGLTextures: Unsupported texture color space:",$)),A}function Xt(L){return typeof HTMLImageElement<"u"&&L instanceof HTMLImageElement?(c.width=L.naturalWidth||L.width,c.height=L.naturalHeight||L.height):typeof VideoFrame<"u"&&L instanceof VideoFrame?(c.width=L.displayWidth,c.height=L.displayHeight):(c.width=L.width,c.height=L.height),c}this.allocateTextureUnit=ft,this.resetTextureUnits=Q,this.getTextureUnits=it,this.setTextureUnits=dt,this.setTexture2D=ut,this.setTexture2DArray=gt,this.setTexture3D=St,this.setTextureCube=Mt,this.rebindTextures=Ye,this.setupRenderTarget=an,this.updateRenderTargetMipmap=k,this.updateMultisampleRenderTarget=$t,this.setupDepthRenderbuffer=pn,this.setupFrameBufferTexture=Ie,this.useMultisampledRTT=wt,this.dispose=G}function TM(n,t){function e(i,s=gs){let r,o=_e.getTransfer(s);if(i===Jn)return n.UNSIGNED_BYTE;if(i===sc)return n.UNSIGNED_SHORT_4_4_4_4;if(i===rc)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Nu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Du)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Iu)return n.BYTE;if(i===Lu)return n.SHORT;if(i===lo)return n.UNSIGNED_SHORT;if(i===ic)return n.INT;if(i===Ci)return n.UNSIGNED_INT;if(i===_i)return n.FLOAT;if(i===Ri)return n.HALF_FLOAT;if(i===Uu)return n.ALPHA;if(i===Ou)return n.RGB;if(i===Pi)return n.RGBA;if(i===ls)return n.DEPTH_COMPONENT;if(i===ms)return n.DEPTH_STENCIL;if(i===oc)return n.RED;if(i===ac)return n.RED_INTEGER;if(i===Ws)return n.RG;if(i===lc)return n.RG_INTEGER;if(i===cc)return n.RGBA_INTEGER;if(i===ya||i===va||i===ba||i===Sa)if(o===Ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===ya)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ba)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Sa)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===ya)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ba)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Sa)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===hc||i===uc||i===fc||i===dc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===hc)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===uc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===fc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===dc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===pc||i===mc||i===gc||i===_c||i===xc||i===Ma||i===yc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===pc||i===mc)return o===Ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===gc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===_c)return r.COMPRESSED_R11_EAC;if(i===xc)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Ma)return r.COMPRESSED_RG11_EAC;if(i===yc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===vc||i===bc||i===Sc||i===Mc||i===wc||i===Ac||i===Tc||i===Ec||i===Cc||i===Rc||i===Pc||i===Ic||i===Lc||i===Nc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===vc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===bc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Sc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Mc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Ac)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Tc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Ec)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Cc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Rc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Pc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Ic)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Lc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Nc)return o===Ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Dc||i===Uc||i===Oc)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Dc)return o===Ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Uc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Oc)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Fc||i===Bc||i===wa||i===kc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Fc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===wa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===kc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===hr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var EM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,CM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,af=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new oa(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Xi({vertexShader:EM,fragmentShader:CM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ln(new la(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},lf=class extends Ei{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,d=null,p=null,x=typeof XRWebGLBinding<"u",g=new af,m={},_=e.getContextAttributes(),w=null,b=null,S=[],M=[],y=new Yt,T=null,I=null,P=new Xn;P.viewport=new qe;let R=new Xn;R.viewport=new qe;let F=[P,R],z=new jl,U=null,G=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(tt){let ut=S[tt];return ut===void 0&&(ut=new to,S[tt]=ut),ut.getTargetRaySpace()},this.getControllerGrip=function(tt){let ut=S[tt];return ut===void 0&&(ut=new to,S[tt]=ut),ut.getGripSpace()},this.getHand=function(tt){let ut=S[tt];return ut===void 0&&(ut=new to,S[tt]=ut),ut.getHandSpace()};function q(tt){let ut=M.indexOf(tt.inputSource);if(ut===-1)return;let gt=S[ut];gt!==void 0&&(gt.update(tt.inputSource,tt.frame,c||o),gt.dispatchEvent({type:tt.type,data:tt.inputSource}))}function H(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",lt);for(let tt=0;tt<S.length;tt++){let ut=M[tt];ut!==null&&(M[tt]=null,S[tt].disconnect(ut))}U=null,G=null,g.reset();for(let tt in m)delete m[tt];if(t.setRenderTarget(w),d=null,f=null,u=null,s=null,b=null,ft.stop(),i.isPresenting=!1,t.setPixelRatio(T),t.setSize(y.width,y.height,!1),I!==null){let tt=I.camera;tt.fov=I.fov,tt.zoom=I.zoom,tt.updateProjectionMatrix(),I=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(tt){r=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(tt){a=tt,i.isPresenting===!0&&qt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(tt){c=tt},this.getBaseLayer=function(){return f!==null?f:d},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(tt){if(s=tt,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",H),s.addEventListener("inputsourceschange",lt),_.xrCompatible!==!0&&await e.makeXRCompatible(),T=t.getPixelRatio(),t.getSize(y),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let gt=null,St=null,Mt=null;_.depth&&(Mt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,gt=_.stencil?ms:ls,St=_.stencil?hr:Ci);let Ht={colorFormat:e.RGBA8,depthFormat:Mt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(Ht),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),b=new ai(f.textureWidth,f.textureHeight,{format:Pi,type:Jn,depthTexture:new fs(f.textureWidth,f.textureHeight,St,void 0,void 0,void 0,void 0,void 0,void 0,gt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let gt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,e,gt),s.updateRenderState({baseLayer:d}),t.setPixelRatio(1),t.setSize(d.framebufferWidth,d.framebufferHeight,!1),b=new ai(d.framebufferWidth,d.framebufferHeight,{format:Pi,type:Jn,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}b.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ft.setContext(s),ft.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function lt(tt){for(let ut=0;ut<tt.removed.length;ut++){let gt=tt.removed[ut],St=M.indexOf(gt);St>=0&&(M[St]=null,S[St].disconnect(gt))}for(let ut=0;ut<tt.added.length;ut++){let gt=tt.added[ut],St=M.indexOf(gt);if(St===-1){for(let Ht=0;Ht<S.length;Ht++)if(Ht>=M.length){M.push(gt),St=Ht;break}else if(M[Ht]===null){M[Ht]=gt,St=Ht;break}if(St===-1)break}let Mt=S[St];Mt&&Mt.connect(gt)}}function J(tt,ut){ut===null?tt.matrixWorld.copy(tt.matrix):tt.matrixWorld.multiplyMatrices(ut.matrixWorld,tt.matrix),tt.matrixWorldInverse.copy(tt.matrixWorld).invert()}this.updateCamera=function(tt){if(s===null)return;let ut=tt.near,gt=tt.far;g.texture!==null&&(g.depthNear>0&&(ut=g.depthNear),g.depthFar>0&&(gt=g.depthFar)),z.near=R.near=P.near=ut,z.far=R.far=P.far=gt,(U!==z.near||G!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),U=z.near,G=z.far),z.layers.mask=tt.layers.mask|6,P.layers.mask=z.layers.mask&-5,R.layers.mask=z.layers.mask&-3;let St=tt.parent,Mt=z.cameras;J(z,St);for(let Ht=0;Ht<Mt.length;Ht++)J(Mt[Ht],St);z.projectionMatrix.copy(P.projectionMatrix),z.projectionMatrixInverse.copy(P.projectionMatrixInverse),I===null&&tt.isPerspectiveCamera&&(I={camera:tt,fov:tt.fov,zoom:tt.zoom}),Q(tt,z,St)};function Q(tt,ut,gt){gt===null?tt.matrix.copy(ut.matrixWorld):(tt.matrix.copy(gt.matrixWorld),tt.matrix.invert(),tt.matrix.multiply(ut.matrixWorld)),tt.matrix.decompose(tt.position,tt.quaternion,tt.scale),tt.updateMatrixWorld(!0),tt.projectionMatrix.copy(ut.projectionMatrix),tt.projectionMatrixInverse.copy(ut.projectionMatrixInverse),tt.isPerspectiveCamera&&(tt.fov=Kr*2*Math.atan(1/tt.projectionMatrix.elements[5]),tt.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(f===null&&d===null))return l},this.setFoveation=function(tt){l=tt,f!==null&&(f.fixedFoveation=tt),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=tt)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(z)},this.getCameraTexture=function(tt){return m[tt]};let it=null;function dt(tt,ut){if(h=ut.getViewerPose(c||o),p=ut,h!==null){let gt=h.views;d!==null&&(t.setRenderTargetFramebuffer(b,d.framebuffer),t.setRenderTarget(b));let St=!1;gt.length!==z.cameras.length&&(z.cameras.length=0,St=!0);for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt],ae=null;if(d!==null)ae=d.getViewport(he);else{let We=u.getViewSubImage(f,he);ae=We.viewport,Vt===0&&(t.setRenderTargetTextures(b,We.colorTexture,We.depthStencilTexture),t.setRenderTarget(b))}let ne=F[Vt];ne===void 0&&(ne=new Xn,ne.layers.enable(Vt),ne.viewport=new qe,F[Vt]=ne),ne.matrix.fromArray(he.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(he.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(ae.x,ae.y,ae.width,ae.height),Vt===0&&(z.matrix.copy(ne.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),St===!0&&z.cameras.push(ne)}let Mt=s.enabledFeatures;if(Mt&&Mt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Vt=u.getDepthInformation(gt[0]);Vt&&Vt.isValid&&Vt.texture&&g.init(Vt,s.renderState)}if(Mt&&Mt.includes("camera-access")&&x){t.state.unbindTexture(),u=i.getBinding();for(let Vt=0;Vt<gt.length;Vt++){let he=gt[Vt].camera;if(he){let ae=m[he];ae||(ae=new oa,m[he]=ae);let ne=u.getCameraImage(he);ae.sourceTexture=ne}}}}for(let gt=0;gt<S.length;gt++){let St=M[gt],Mt=S[gt];St!==null&&Mt!==void 0&&Mt.update(St,ut,c||o)}it&&it(tt,ut),ut.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ut}),p=null}let ft=new xm;ft.setAnimationLoop(dt),this.setAnimationLoop=function(tt){it=tt},this.dispose=function(){}}},RM=new pe,Cm=new ee;Cm.set(-1,0,0,0,1,0,0,0,1);function PM(n,t){function e(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,Yu(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,_,w,b){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),u(g,m)):m.isMeshPhongMaterial?(r(g,m),h(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),f(g,m),m.isMeshPhysicalMaterial&&d(g,m,b)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),x(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,_,w):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,e(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===$n&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,e(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===$n&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,e(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,e(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,e(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let _=t.get(m),w=_.envMap,b=_.envMapRotation;w&&(g.envMap.value=w,g.envMapRotation.value.setFromMatrix4(RM.makeRotationFromEuler(b)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(Cm),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,e(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,e(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,_,w){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*_,g.scale.value=w*.5,m.map&&(g.map.value=m.map,e(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,e(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,e(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function h(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function u(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function f(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,e(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,e(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,_){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,e(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,e(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,e(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,e(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,e(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,e(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===$n&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,e(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,e(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,e(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,e(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,e(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,e(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,e(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function x(g,m){let _=t.get(m).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function IM(n,t,e,i){let s={},r={};function o(_,w){let b=w.program;i.uniformBlockBinding(_,b,s[_.id])}function a(_,w){let b=s[_.id];b===void 0&&(p(_),b=l(_),s[_.id]=b,_.addEventListener("dispose",g));let S=w.program;i.updateUBOMapping(_,S);let M=t.render.frame;r[_.id]!==M&&(c(_),r[_.id]=M)}function l(_){let w=n.createBuffer(),b=_.__size,S=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,b,S),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(_){let w=s[_.id],b=_.uniforms,S=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let M=0,y=b.length;M<y;M++){let T=b[M];if(Array.isArray(T))for(let I=0,P=T.length;I<P;I++)h(T[I],M,I,S);else h(T,M,0,S)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,w,b,S){if(f(_,w,b,S)===!0){let M=_.__offset,y=_.value;if(Array.isArray(y)){let T=0;for(let I=0;I<y.length;I++){let P=y[I],R=x(P,!0);u(P,_.__data,T),T+=R.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,M,_.__data)}}function u(_,w,b){typeof _=="number"||typeof _=="boolean"?w[b]=_:_.isMatrix3?(w[b]=_.elements[0],w[b+1]=_.elements[1],w[b+2]=_.elements[2],w[b+3]=0,w[b+4]=_.elements[3],w[b+5]=_.elements[4],w[b+6]=_.elements[5],w[b+7]=0,w[b+8]=_.elements[6],w[b+9]=_.elements[7],w[b+10]=_.elements[8],w[b+11]=0):ArrayBuffer.isView(_)?w.set(_.subarray(0,w.length-b),b):_.toArray(w,b)}function f(_,w,b,S){let M=_.value,y=w+"_"+b;if(Array.isArray(M)){S[y]===void 0&&(S[y]=[]);let T=S[y],I=!1;for(let P=0;P<M.length;P++)d(M[P],T,P)===!0&&(I=!0);return I}return d(M,S,y)}function d(_,w,b){if(w[b]===void 0)return typeof _=="number"||typeof _=="boolean"?w[b]=_:ArrayBuffer.isView(_)?w[b]=_.slice():w[b]=_.clone(),!0;{let S=w[b];if(typeof _=="number"||typeof _=="boolean"){if(S!==_)return w[b]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(S.equals(_)===!1)return S.copy(_),!0}}return!1}function p(_){let w=_.uniforms,b=0,S=16;for(let y=0,T=w.length;y<T;y++){let I=Array.isArray(w[y])?w[y]:[w[y]];for(let P=0,R=I.length;P<R;P++){let F=I[P],z=Array.isArray(F.value)?F.value:[F.value],U=Array.isArray(w[y])||Array.isArray(F.value),G=b;for(let H=0,lt=z.length;H<lt;H++){let J=z[H],Q=x(J,U),it=b%S,dt=it%Q.boundary,ft=it+dt;b+=dt,ft!==0&&S-ft<Q.storage&&(b+=S-ft),H===0&&(G=b),b+=Q.storage}let q=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new q((b-G)/Float32Array.BYTES_PER_ELEMENT),F.__offset=G}}let M=b%S;return M>0&&(b+=S-M),_.__size=b,_.__cache={},this}function x(_,w){let b={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(b.boundary=4,b.storage=4):_.isVector2?(b.boundary=8,b.storage=8):_.isVector3||_.isColor?(b.boundary=16,b.storage=12):_.isVector4?(b.boundary=16,b.storage=16):_.isMatrix3?(b.boundary=16,b.storage=48):_.isMatrix4?(b.boundary=16,b.storage=64):_.isTexture?qt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(b.boundary=16,b.storage=_.byteLength):qt("WebGLRenderer: Unsupported uniform value type.",_),w===!0&&(b.boundary=16,b.storage=Math.ceil(b.storage/16)*16),b}function g(_){let w=_.target;w.removeEventListener("dispose",g),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function m(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:m}}var LM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),$i=null;function NM(){return $i===null&&($i=new na(LM,16,16,Ws,Ri),$i.name="DFG_LUT",$i.minFilter=qn,$i.magFilter=qn,$i.wrapS=Gi,$i.wrapT=Gi,$i.generateMipmaps=!1,$i.needsUpdate=!0),$i}var Wc=class{constructor(t={}){let{canvas:e=Vp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:d=Jn}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let x=d,g=new Set([cc,lc,ac]),m=new Set([Jn,Ci,lo,hr,sc,rc]),_=new Uint32Array(4),w=new Int32Array(4),b={textures:[],min:[],max:[],resolution:[]},S=null,M=null,y=[],T=[],I=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let P=this,R=!1,F=null,z=null,U=null,G=null;this._outputColorSpace=si;let q=0,H=0,lt=null,J=-1,Q=null,it=new qe,dt=new qe,ft=null,tt=new Qt(0),ut=0,gt=e.width,St=e.height,Mt=1,Ht=null,se=null,Vt=new qe(0,0,gt,St),he=new qe(0,0,gt,St),ae=!1,ne=new Os,We=new Dl,Oe=!1,on=!1,Ie=new pe,Sn=new W,ye=new qe,pn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Ye=!1;function an(){return lt===null?Mt:1}let k=i;function Rt(C,V){return e.getContext(C,V)}let $t,re,wt,Ne,zt,Xt,L,A,$,ht,ot,xt,yt,et,st,mt,B,rt,nt,At,_t,bt,Gt;try{let C={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ft,!1),e.addEventListener("webglcontextrestored",Kt,!1),e.addEventListener("webglcontextcreationerror",Ct,!1),k===null){let V="webgl2";if(k=Rt(V,C),k===null)throw Rt(V)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Jt()}catch(C){throw e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),jt("WebGLRenderer: "+C.message),C}function Jt(){$t=new Wb(k),$t.init(),_t=new TM(k,$t),re=new Nb(k,$t,t,_t),wt=new wM(k,$t),re.reversedDepthBuffer&&f&&wt.buffers.depth.setReversed(!0),z=k.createFramebuffer(),U=k.createFramebuffer(),G=k.createFramebuffer(),Ne=new $b(k),zt=new hM,Xt=new AM(k,$t,wt,zt,re,_t,Ne),L=new Hb(P),A=new Zx(k),bt=new Ib(k,A),$=new Xb(k,A,Ne,bt),ht=new Zb(k,$,A,bt,Ne),rt=new Yb(k,re,Xt),st=new Db(zt),ot=new cM(P,L,$t,re,bt,st),xt=new PM(P,zt),yt=new fM,et=new xM($t),B=new Pb(P,L,wt,ht,p,l),mt=new MM(P,ht,re),Gt=new IM(k,Ne,re,wt),nt=new Lb(k,$t,Ne),At=new qb(k,$t,Ne),Ne.programs=ot.programs,P.capabilities=re,P.extensions=$t,P.properties=zt,P.renderLists=yt,P.shadowMap=mt,P.state=wt,P.info=Ne}x!==Jn&&(I=new Kb(x,e.width,e.height,a,s,r));let ct=new lf(P,k);this.xr=ct,this.getContext=function(){return k},this.getContextAttributes=function(){return k.getContextAttributes()},this.forceContextLoss=function(){let C=$t.get("WEBGL_lose_context");C&&C.loseContext()},this.forceContextRestore=function(){let C=$t.get("WEBGL_lose_context");C&&C.restoreContext()},this.getPixelRatio=function(){return Mt},this.setPixelRatio=function(C){C!==void 0&&(Mt=C,this.setSize(gt,St,!1))},this.getSize=function(C){return C.set(gt,St)},this.setSize=function(C,V,j=!0){if(ct.isPresenting){qt("WebGLRenderer: Can't change size while VR device is presenting.");return}gt=C,St=V,e.width=Math.floor(C*Mt),e.height=Math.floor(V*Mt),j===!0&&(e.style.width=C+"px",e.style.height=V+"px"),I!==null&&I.setSize(e.width,e.height),this.setViewport(0,0,C,V)},this.getDrawingBufferSize=function(C){return C.set(gt*Mt,St*Mt).floor()},this.setDrawingBufferSize=function(C,V,j){gt=C,St=V,Mt=j,e.width=Math.floor(C*j),e.height=Math.floor(V*j),this.setViewport(0,0,C,V)},this.setEffects=function(C){if(x===Jn){jt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(C){for(let V=0;V<C.length;V++)if(C[V].isOutputPass===!0){qt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}I.setEffects(C||[])},this.getCurrentViewport=function(C){return C.copy(it)},this.getViewport=function(C){return C.copy(Vt)},this.setViewport=function(C,V,j,Y){C.isVector4?Vt.set(C.x,C.y,C.z,C.w):Vt.set(C,V,j,Y),wt.viewport(it.copy(Vt).multiplyScalar(an()).round())},this.getScissor=function(C){return C.copy(he)},this.setScissor=function(C,V,j,Y){C.isVector4?he.set(C.x,C.y,C.z,C.w):he.set(C,V,j,Y),wt.scissor(dt.copy(he).multiplyScalar(an()).round())},this.getScissorTest=function(){return ae},this.setScissorTest=function(C){wt.setScissorTest(ae=C)},this.setOpaqueSort=function(C){Ht=C},this.setTransparentSort=function(C){se=C},this.getClearColor=function(C){return C.copy(B.getClearColor())},this.setClearColor=function(){B.setClearColor(...arguments)},this.getClearAlpha=function(){return B.getClearAlpha()},this.setClearAlpha=function(){B.setClearAlpha(...arguments)},this.clear=function(C=!0,V=!0,j=!0){let Y=0;if(C){let Z=!1;if(lt!==null){let Tt=lt.texture.format;Z=g.has(Tt)}if(Z){let Tt=lt.texture.type,Pt=m.has(Tt),Et=B.getClearColor(),It=B.getClearAlpha(),kt=Et.r,te=Et.g,ue=Et.b;Pt?(_[0]=kt,_[1]=te,_[2]=ue,_[3]=It,k.clearBufferuiv(k.COLOR,0,_)):(w[0]=kt,w[1]=te,w[2]=ue,w[3]=It,k.clearBufferiv(k.COLOR,0,w))}else Y|=k.COLOR_BUFFER_BIT}V&&(Y|=k.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=k.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&k.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(C){C.setRenderer(this),F=C},this.dispose=function(){e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Kt,!1),e.removeEventListener("webglcontextcreationerror",Ct,!1),B.dispose(),yt.dispose(),et.dispose(),Xt.dispose(),zt.dispose(),L.dispose(),ht.dispose(),$.dispose(),bt.dispose(),Gt.dispose(),ot.dispose(),ct.dispose(),ct.removeEventListener("sessionstart",Xa),ct.removeEventListener("sessionend",Di),Ki.stop()};function Ft(C){C.preventDefault(),Hu("WebGLRenderer: Context Lost."),R=!0}function Kt(){Hu("WebGLRenderer: Context Restored."),R=!1;let C=Ne.autoReset,V=mt.enabled,j=mt.autoUpdate,Y=mt.needsUpdate,Z=mt.type;Jt(),Ne.autoReset=C,mt.enabled=V,mt.autoUpdate=j,mt.needsUpdate=Y,mt.type=Z}function Ct(C){jt("WebGLRenderer: A WebGL context could not be created. Reason: ",C.statusMessage)}function oe(C){let V=C.target;V.removeEventListener("dispose",oe),Be(V)}function Be(C){zn(C),zt.remove(C)}function zn(C){let V=zt.get(C).programs;V!==void 0&&(V.forEach(function(j){ot.releaseProgram(j)}),C.isShaderMaterial&&ot.releaseShaderCache(C))}this.renderBufferDirect=function(C,V,j,Y,Z,Tt){V===null&&(V=pn);let Pt=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Et=No(C,V,j,Y,Z);wt.setMaterial(Y,Pt);let It=j.index,kt=1;if(Y.wireframe===!0){if(It=$.getWireframeAttribute(j),It===void 0)return;kt=2}let te=j.drawRange,ue=j.attributes.position,Bt=te.start*kt,fe=(te.start+te.count)*kt;Tt!==null&&(Bt=Math.max(Bt,Tt.start*kt),fe=Math.min(fe,(Tt.start+Tt.count)*kt)),It!==null?(Bt=Math.max(Bt,0),fe=Math.min(fe,It.count)):ue!=null&&(Bt=Math.max(Bt,0),fe=Math.min(fe,ue.count));let $e=fe-Bt;if($e<0||$e===1/0)return;bt.setup(Z,Y,Et,j,It);let Ce,Re=nt;if(It!==null&&(Ce=A.get(It),Re=At,Re.setIndex(Ce)),Z.isMesh)Y.wireframe===!0?(wt.setLineWidth(Y.wireframeLinewidth*an()),Re.setMode(k.LINES)):Re.setMode(k.TRIANGLES);else if(Z.isLine){let mn=Y.linewidth;mn===void 0&&(mn=1),wt.setLineWidth(mn*an()),Z.isLineSegments?Re.setMode(k.LINES):Z.isLineLoop?Re.setMode(k.LINE_LOOP):Re.setMode(k.LINE_STRIP)}else Z.isPoints?Re.setMode(k.POINTS):Z.isSprite&&Re.setMode(k.TRIANGLES);if(Z.isBatchedMesh)if($t.get("WEBGL_multi_draw"))Re.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let mn=Z._multiDrawStarts,Ut=Z._multiDrawCounts,ln=Z._multiDrawCount,ge=It?A.get(It).bytesPerElement:1,Qi=zt.get(Y).currentProgram.getUniforms();for(let cn=0;cn<ln;cn++)Qi.setValue(k,"_gl_DrawID",cn),Re.render(mn[cn]/ge,Ut[cn])}else if(Z.isInstancedMesh)Re.renderInstances(Bt,$e,Z.count);else if(j.isInstancedBufferGeometry){let mn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ut=Math.min(j.instanceCount,mn);Re.renderInstances(Bt,$e,Ut)}else Re.render(Bt,$e)};function Po(C,V,j,Y){F!==null&&C.isNodeMaterial&&F.setObject(Y,C),Oe===!0&&st.setState(C,j,!1),C.transparent===!0&&C.side===Bn&&C.forceSinglePass===!1?(C.side=$n,C.needsUpdate=!0,Ui(C,V,Y),C.side=Hs,C.needsUpdate=!0,Ui(C,V,Y),C.side=Bn):Ui(C,V,Y)}this.compile=function(C,V,j=null){j===null&&(j=C),F!==null&&F.renderStart(C,V,j),M=et.get(j),M.init(V),T.push(M),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),C!==j&&C.traverseVisible(function(Z){Z.isLight&&Z.layers.test(V.layers)&&(M.pushLight(Z),Z.castShadow&&M.pushShadow(Z))}),M.setupLights(),F!==null&&F.updateLights(M.state.lightsArray),on=this.localClippingEnabled,Oe=st.init(this.clippingPlanes,on),Oe===!0&&st.setGlobalState(this.clippingPlanes,V),F!==null&&mt.render(M.state.shadowsArray,j,V);let Y=new Set;return C.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Tt=Z.material;if(Tt)if(Array.isArray(Tt))for(let Pt=0;Pt<Tt.length;Pt++){let Et=Tt[Pt];Po(Et,j,V,Z),Y.add(Et)}else Po(Tt,j,V,Z),Y.add(Tt)}),M=T.pop(),F!==null&&F.renderEnd(),Y},this.compileAsync=function(C,V,j=null){let Y=this.compile(C,V,j);return new Promise(Z=>{function Tt(){if(Y.forEach(function(Pt){let It=zt.get(Pt).currentProgram;(It===void 0||It.isReady())&&Y.delete(Pt)}),Y.size===0){Z(C);return}setTimeout(Tt,10)}$t.get("KHR_parallel_shader_compile")!==null?Tt():setTimeout(Tt,10)})};let Sr=null;function Lh(C){Sr&&Sr(C)}function Xa(){Ki.stop()}function Di(){Ki.start()}let Ki=new xm;Ki.setAnimationLoop(Lh),typeof self<"u"&&Ki.setContext(self),this.setAnimationLoop=function(C){Sr=C,ct.setAnimationLoop(C),C===null?Ki.stop():Ki.start()},ct.addEventListener("sessionstart",Xa),ct.addEventListener("sessionend",Di),this.render=function(C,V){if(V!==void 0&&V.isCamera!==!0){jt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(R===!0)return;F!==null&&F.renderStart(C,V);let j=ct.enabled===!0&&ct.isPresenting===!0,Y=I!==null&&(lt===null||j)&&I.begin(P,lt);if(C.matrixWorldAutoUpdate===!0&&C.updateMatrixWorld(),V.parent===null&&V.matrixWorldAutoUpdate===!0&&V.updateMatrixWorld(),ct.enabled===!0&&ct.isPresenting===!0&&(I===null||I.isCompositing()===!1)&&(ct.cameraAutoUpdate===!0&&ct.updateCamera(V),V=ct.getCamera()),C.isScene===!0&&C.onBeforeRender(P,C,V,lt),M=et.get(C,T.length),M.init(V),M.state.textureUnits=Xt.getTextureUnits(),T.push(M),Ie.multiplyMatrices(V.projectionMatrix,V.matrixWorldInverse),V.isArrayCamera?We.setFromArrayCamera(V):ne.setFromProjectionMatrix(Ie,gi,V.reversedDepth),on=this.localClippingEnabled,Oe=st.init(this.clippingPlanes,on),S=yt.get(C,y.length),S.init(),y.push(S),this.info.render.frame++,ct.enabled===!0&&ct.isPresenting===!0){let Pt=P.xr.getDepthSensingMesh();Pt!==null&&ji(Pt,V,-1/0,P.sortObjects)}ji(C,V,0,P.sortObjects),S.finish(),F!==null&&F.updateLights(M.state.lightsArray),P.sortObjects===!0&&S.sort(Ht,se),Ye=ct.enabled===!1||ct.isPresenting===!1||ct.hasDepthSensing()===!1,Ye&&B.addToRenderList(S,C),this.info.autoReset===!0&&this.info.reset(),Oe===!0&&st.beginShadows();let Z=M.state.shadowsArray;if(mt.render(Z,C,V),Oe===!0&&st.endShadows(),(Y&&I.hasRenderPass())===!1){let Pt=S.opaque,Et=S.transmissive;if(M.setupLights(),V.isArrayCamera){let It=V.cameras;if(Et.length>0)for(let kt=0,te=It.length;kt<te;kt++){let ue=It[kt];bi(Pt,Et,C,ue)}Ye&&B.render(C);for(let kt=0,te=It.length;kt<te;kt++){let ue=It[kt];Io(S,C,ue,ue.viewport)}}else Et.length>0&&bi(Pt,Et,C,V),Ye&&B.render(C),Io(S,C,V)}lt!==null&&H===0&&(Xt.updateMultisampleRenderTarget(lt),Xt.updateRenderTargetMipmap(lt)),Y&&I.end(P),C.isScene===!0&&C.onAfterRender(P,C,V),bt.resetDefaultState(),J=-1,Q=null,T.pop(),T.length>0?(M=T[T.length-1],Xt.setTextureUnits(M.state.textureUnits),Oe===!0&&st.setGlobalState(P.clippingPlanes,M.state.camera)):M=null,y.pop(),y.length>0?S=y[y.length-1]:S=null,F!==null&&F.renderEnd()};function ji(C,V,j,Y){if(C.visible===!1)return;if(C.layers.test(V.layers)){if(C.isGroup)j=C.renderOrder;else if(C.isLOD)C.autoUpdate===!0&&C.update(V);else if(C.isLight)M.pushLight(C),C.castShadow&&M.pushShadow(C);else if(C.isSprite){let Pt=V.isArrayCamera?We:ne;if(!C.frustumCulled||C.intersectsFrustum(Pt)){Y&&ye.setFromMatrixPosition(C.matrixWorld).applyMatrix4(Ie);let Et=ht.update(C),It=C.material;It.visible&&S.push(C,Et,It,j,ye.z,null,V)}}else if(C.isMesh||C.isLine||C.isPoints){let Pt=V.isArrayCamera?We:ne;if(!C.frustumCulled||C.intersectsFrustum(Pt)){let Et=ht.update(C),It=C.material;if(Y&&(C.boundingSphere!==void 0?(C.boundingSphere===null&&C.computeBoundingSphere(),ye.copy(C.boundingSphere.center)):(Et.boundingSphere===null&&Et.computeBoundingSphere(),ye.copy(Et.boundingSphere.center)),ye.applyMatrix4(C.matrixWorld).applyMatrix4(Ie)),Array.isArray(It)){let kt=Et.groups;for(let te=0,ue=kt.length;te<ue;te++){let Bt=kt[te],fe=It[Bt.materialIndex];fe&&fe.visible&&S.push(C,Et,fe,j,ye.z,Bt,V)}}else It.visible&&S.push(C,Et,It,j,ye.z,null,V)}}}let Tt=C.children;for(let Pt=0,Et=Tt.length;Pt<Et;Pt++)ji(Tt[Pt],V,j,Y)}function Io(C,V,j,Y){let{opaque:Z,transmissive:Tt,transparent:Pt}=C;M.setupLightsView(j),Oe===!0&&st.setGlobalState(P.clippingPlanes,j),Y&&wt.viewport(it.copy(Y)),Z.length>0&&Ze(Z,V,j),Tt.length>0&&Ze(Tt,V,j),Pt.length>0&&Ze(Pt,V,j),wt.buffers.depth.setTest(!0),wt.buffers.depth.setMask(!0),wt.buffers.color.setMask(!0),wt.setPolygonOffset(!1)}function bi(C,V,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(M.state.transmissionRenderTarget[Y.id]===void 0){let Bt=$t.has("EXT_color_buffer_half_float")||$t.has("EXT_color_buffer_float");M.state.transmissionRenderTarget[Y.id]=new ai(1,1,{generateMipmaps:!0,type:Bt?Ri:Jn,minFilter:ps,samples:Math.max(4,re.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:_e.workingColorSpace})}let Tt=M.state.transmissionRenderTarget[Y.id],Pt=Y.viewport||it;Tt.setSize(Pt.z*P.transmissionResolutionScale,Pt.w*P.transmissionResolutionScale);let Et=P.getRenderTarget(),It=P.getActiveCubeFace(),kt=P.getActiveMipmapLevel();P.setRenderTarget(Tt),P.getClearColor(tt),ut=P.getClearAlpha(),ut<1&&P.setClearColor(16777215,.5),P.clear(),Ye&&B.render(j);let te=P.toneMapping;P.toneMapping=qi;let ue=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),M.setupLightsView(Y),Oe===!0&&st.setGlobalState(P.clippingPlanes,Y),Ze(C,j,Y),Xt.updateMultisampleRenderTarget(Tt),Xt.updateRenderTargetMipmap(Tt),$t.has("WEBGL_multisampled_render_to_texture")===!1){let Bt=!1;for(let fe=0,$e=V.length;fe<$e;fe++){let Ce=V[fe],{object:Re,geometry:mn,material:Ut,group:ln}=Ce;if(Ut.side===Bn&&Re.layers.test(Y.layers)){let ge=Ut.side;Ut.side=$n,Ut.needsUpdate=!0,en(Re,j,Y,mn,Ut,ln),Ut.side=ge,Ut.needsUpdate=!0,Bt=!0}}Bt===!0&&(Xt.updateMultisampleRenderTarget(Tt),Xt.updateRenderTargetMipmap(Tt))}P.setRenderTarget(Et,It,kt),P.setClearColor(tt,ut),ue!==void 0&&(Y.viewport=ue),P.toneMapping=te}function Ze(C,V,j){let Y=V.isScene===!0?V.overrideMaterial:null;for(let Z=0,Tt=C.length;Z<Tt;Z++){let Pt=C[Z],{object:Et,geometry:It,group:kt}=Pt,te=Pt.material;te.allowOverride===!0&&Y!==null&&(te=Y),Et.layers.test(j.layers)&&en(Et,V,j,It,te,kt)}}function en(C,V,j,Y,Z,Tt){F!==null&&Z.isNodeMaterial&&F.setObject(C,Z),C.onBeforeRender(P,V,j,Y,Z,Tt),C.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,C.matrixWorld),C.normalMatrix.getNormalMatrix(C.modelViewMatrix),Z.onBeforeRender(P,V,j,Y,C,Tt),Z.transparent===!0&&Z.side===Bn&&Z.forceSinglePass===!1?(Z.side=$n,Z.needsUpdate=!0,P.renderBufferDirect(j,V,Y,Z,C,Tt),Z.side=Hs,Z.needsUpdate=!0,P.renderBufferDirect(j,V,Y,Z,C,Tt),Z.side=Bn):P.renderBufferDirect(j,V,Y,Z,C,Tt),C.onAfterRender(P,V,j,Y,Z,Tt)}function nn(C){let V=0;for(let j of C)j.texture!==null&&V++;return V}function Ui(C,V,j){V.isScene!==!0&&(V=pn);let Y=zt.get(C),Z=M.state.lights,Tt=M.state.shadowsArray,Pt=Z.state.version,Et=ot.getParameters(C,Z.state,Tt,V,j,M.state.lightProbeGridArray),It=ot.getProgramCacheKey(Et),kt=Y.programs;Y.environment=C.isMeshStandardMaterial||C.isMeshLambertMaterial||C.isMeshPhongMaterial?V.environment:null,Y.fog=V.fog;let te=C.isMeshStandardMaterial||C.isMeshLambertMaterial&&!C.envMap||C.isMeshPhongMaterial&&!C.envMap;Y.envMap=L.get(C.envMap||Y.environment,te),Y.envMapRotation=Y.environment!==null&&C.envMap===null?V.environmentRotation:C.envMapRotation,kt===void 0&&(C.addEventListener("dispose",oe),kt=new Map,Y.programs=kt,Y.programVariants=new Map);let ue=kt.get(It);if(ue!==void 0){if(Y.currentProgram===ue&&Y.lightsStateVersion===Pt)return Lo(C,Et),ue}else Et.uniforms=ot.getUniforms(C),F!==null&&C.isNodeMaterial&&F.build(C,j,Et),C.onBeforeCompile(Et,P),ue=ot.acquireProgram(Et,It),kt.set(It,ue),Y.uniforms=Et.uniforms;let Bt=Y.uniforms;return(!C.isShaderMaterial&&!C.isRawShaderMaterial||C.clipping===!0)&&(Bt.clippingPlanes=st.uniform),Lo(C,Et),Y.needsLights=ws(C),Y.lightsStateVersion=Pt,Y.needsLights&&(Bt.ambientLightColor.value=Z.state.ambient,Bt.lightProbe.value=Z.state.probe,Bt.sunLights.value=Z.state.sun,Bt.sunLightShadows.value=Z.state.sunShadow,Bt.directionalLights.value=Z.state.directional,Bt.directionalLightShadows.value=Z.state.directionalShadow,Bt.spotLights.value=Z.state.spot,Bt.spotLightShadows.value=Z.state.spotShadow,Bt.rectAreaLights.value=Z.state.rectArea,Bt.ltc_1.value=Z.state.rectAreaLTC1,Bt.ltc_2.value=Z.state.rectAreaLTC2,Bt.pointLights.value=Z.state.point,Bt.pointLightShadows.value=Z.state.pointShadow,Bt.hemisphereLights.value=Z.state.hemi,Bt.sunShadowMatrix.value=Z.state.sunShadowMatrix,Bt.sunShadowCascade.value=Z.state.sunShadowCascade,Bt.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Bt.spotLightMatrix.value=Z.state.spotLightMatrix,Bt.spotLightMap.value=Z.state.spotLightMap,Bt.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=nn(M.state.lightProbeGridArray),Y.currentProgram=ue,Y.uniformsList=null,ue}function jn(C,V,j,Y,Z){let Tt=zt.get(C),Pt=Tt.currentProgram.id+","+Y+","+Z,Et=Tt.programVariants.get(Pt);return Et===void 0?(Et=Ui(C,V,j),Tt.programVariants.set(Pt,Et)):(Tt.currentProgram=Et,Tt.uniformsList=null,Tt.outputColorSpace=Y,Tt.toneMapping=Z),Et}function Ms(C){if(C.uniformsList===null){let V=C.currentProgram.getUniforms();C.uniformsList=ho.seqWithValue(V.seq,C.uniforms)}return C.uniformsList}function Lo(C,V){let j=zt.get(C);j.outputColorSpace=V.outputColorSpace,j.batching=V.batching,j.batchingColor=V.batchingColor,j.instancing=V.instancing,j.instancingColor=V.instancingColor,j.instancingMorph=V.instancingMorph,j.skinning=V.skinning,j.morphTargets=V.morphTargets,j.morphNormals=V.morphNormals,j.morphColors=V.morphColors,j.morphTargetsCount=V.morphTargetsCount,j.numClippingPlanes=V.numClippingPlanes,j.numIntersection=V.numClipIntersection,j.vertexAlphas=V.vertexAlphas,j.vertexTangents=V.vertexTangents,j.toneMapping=V.toneMapping}function No(C,V,j,Y,Z){V.isScene!==!0&&(V=pn),Xt.resetTextureUnits();let Tt=V.fog,Pt=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?V.environment:null,Et=lt===null?P.outputColorSpace:lt.isXRRenderTarget===!0?lt.texture.colorSpace:_e.workingColorSpace,It=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,kt=L.get(Y.envMap||Pt,It),te=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,ue=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Bt=!!j.morphAttributes.position,fe=!!j.morphAttributes.normal,$e=!!j.morphAttributes.color,Ce=qi;Y.toneMapped&&(lt===null||lt.isXRRenderTarget===!0)&&(Ce=P.toneMapping);let Re=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,mn=Re!==void 0?Re.length:0,Ut=zt.get(Y),ln=M.state.lights;if(Oe===!0&&(on===!0||C!==Q)){let Pe=C===Q&&Y.id===J;st.setState(Y,C,Pe)}let ge=!1,Qi=!1;Y.version===Ut.__version?Ut.needsLights&&Ut.lightsStateVersion!==ln.state.version||Z.isBatchedMesh&&Ut.batching===!1||!Z.isBatchedMesh&&Ut.batching===!0||Z.isBatchedMesh&&Ut.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Ut.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Ut.instancing===!1||!Z.isInstancedMesh&&Ut.instancing===!0||Z.isSkinnedMesh&&Ut.skinning===!1||!Z.isSkinnedMesh&&Ut.skinning===!0||Z.isInstancedMesh&&Ut.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Ut.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Ut.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Ut.instancingMorph===!1&&Z.morphTexture!==null||Ut.envMap!==kt||Y.fog===!0&&Ut.fog!==Tt||Ut.numClippingPlanes!==void 0&&(Ut.numClippingPlanes!==st.numPlanes||Ut.numIntersection!==st.numIntersection)||Ut.vertexAlphas!==te||Ut.vertexTangents!==ue||Ut.morphTargets!==Bt||Ut.morphNormals!==fe||Ut.morphColors!==$e||Ut.morphTargetsCount!==mn||Ut.numLightProbeGrids!==nn(M.state.lightProbeGridArray)?ge=!0:(Ut.outputColorSpace!==Et||Ut.toneMapping!==Ce)&&(Qi=!0):(ge=!0,Ut.__version=Y.version);let cn=Ut.currentProgram;(ge===!0||Qi===!0)&&(cn=Qi===!0?jn(Y,V,Z,Et,Ce):Ui(Y,V,Z),F&&Y.isNodeMaterial&&F.onUpdateProgram(Y,cn,Ut));let Ar=!1,Oi=!1,ts=!1,le=cn.getUniforms(),Je=Ut.uniforms;if(wt.useProgram(cn.program)&&(Ar=!0,Oi=!0,ts=!0),Y.id!==J&&(J=Y.id,Oi=!0),Ar||Q!==C){wt.buffers.depth.getReversed()&&C.reversedDepth!==!0&&(C._reversedDepth=!0,C.updateProjectionMatrix()),le.setValue(k,"projectionMatrix",C.projectionMatrix),le.setValue(k,"viewMatrix",C.matrixWorldInverse);let hn=le.map.cameraPosition;hn!==void 0&&hn.setValue(k,Sn.setFromMatrixPosition(C.matrixWorld)),re.logarithmicDepthBuffer&&le.setValue(k,"logDepthBufFC",2/(Math.log(C.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&le.setValue(k,"isOrthographic",C.isOrthographicCamera===!0),Q!==C&&(Q=C,Oi=!0,ts=!0)}if(Ut.needsLights&&(ln.state.sunShadowMap.length>0&&le.setValue(k,"sunShadowMap",ln.state.sunShadowMap,Xt),ln.state.directionalShadowMap.length>0&&le.setValue(k,"directionalShadowMap",ln.state.directionalShadowMap,Xt),ln.state.spotShadowMap.length>0&&le.setValue(k,"spotShadowMap",ln.state.spotShadowMap,Xt),ln.state.pointShadowMap.length>0&&le.setValue(k,"pointShadowMap",ln.state.pointShadowMap,Xt)),Z.isSkinnedMesh){le.setOptional(k,Z,"bindMatrix"),le.setOptional(k,Z,"bindMatrixInverse");let Pe=Z.skeleton;Pe&&(Pe.boneTexture===null&&Pe.computeBoneTexture(),le.setValue(k,"boneTexture",Pe.boneTexture,Xt))}Z.isBatchedMesh&&(le.setOptional(k,Z,"batchingTexture"),le.setValue(k,"batchingTexture",Z._matricesTexture,Xt),le.setOptional(k,Z,"batchingIdTexture"),le.setValue(k,"batchingIdTexture",Z._indirectTexture,Xt),le.setOptional(k,Z,"batchingColorTexture"),Z._colorsTexture!==null&&le.setValue(k,"batchingColorTexture",Z._colorsTexture,Xt));let Vn=j.morphAttributes;if((Vn.position!==void 0||Vn.normal!==void 0||Vn.color!==void 0)&&rt.update(Z,j,cn),(Oi||Ut.receiveShadow!==Z.receiveShadow)&&(Ut.receiveShadow=Z.receiveShadow,le.setValue(k,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&V.environment!==null&&(Je.envMapIntensity.value=V.environmentIntensity),Je.dfgLUT!==void 0&&(Je.dfgLUT.value=NM()),Oi){if(le.setValue(k,"toneMappingExposure",P.toneMappingExposure),Ut.needsLights&&Mr(Je,ts),Tt&&Y.fog===!0&&xt.refreshFogUniforms(Je,Tt),xt.refreshMaterialUniforms(Je,Y,Mt,St,M.state.transmissionRenderTarget[C.id]),Ut.needsLights&&Ut.numLightProbeGrids>0){let Pe=b,hn=0;for(let Dn of M.state.lightProbeGridArray)Dn.texture!==null&&(Pe.textures[hn]=Dn.texture,Pe.min[hn]=Dn.boundingBox.min,Pe.max[hn]=Dn.boundingBox.max,Pe.resolution[hn]=Dn.resolution,hn++);for(let Dn in Pe)Pe[Dn].length=hn;Je.probesSH.value=Pe.textures,Je.probesMin.value=Pe.min,Je.probesMax.value=Pe.max,Je.probesResolution.value=Pe.resolution}ho.upload(k,Ms(Ut),Je,Xt)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(ho.upload(k,Ms(Ut),Je,Xt),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&le.setValue(k,"center",Z.center),le.setValue(k,"modelViewMatrix",Z.modelViewMatrix),le.setValue(k,"normalMatrix",Z.normalMatrix),le.setValue(k,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Pe=Y.uniformsGroups;for(let hn=0,Dn=Pe.length;hn<Dn;hn++){let qa=Pe[hn];Gt.update(qa,cn),Gt.bind(qa,cn)}}return cn}function Mr(C,V){C.ambientLightColor.needsUpdate=V,C.lightProbe.needsUpdate=V,C.sunLights.needsUpdate=V,C.sunLightShadows.needsUpdate=V,C.directionalLights.needsUpdate=V,C.directionalLightShadows.needsUpdate=V,C.pointLights.needsUpdate=V,C.pointLightShadows.needsUpdate=V,C.spotLights.needsUpdate=V,C.spotLightShadows.needsUpdate=V,C.rectAreaLights.needsUpdate=V,C.hemisphereLights.needsUpdate=V}function ws(C){return C.isMeshLambertMaterial||C.isMeshToonMaterial||C.isMeshPhongMaterial||C.isMeshStandardMaterial||C.isShadowMaterial||C.isShaderMaterial&&C.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return lt},this.setRenderTargetTextures=function(C,V,j){let Y=zt.get(C);Y.__autoAllocateDepthBuffer=C.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),zt.get(C.texture).__webglTexture=V,zt.get(C.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(C,V){let j=zt.get(C);j.__webglFramebuffer=V,j.__useDefaultFramebuffer=V===void 0},this.setRenderTarget=function(C,V=0,j=0){lt=C,q=V,H=j;let Y=null,Z=!1,Tt=!1;if(C){let Et=zt.get(C);if(Et.__useDefaultFramebuffer!==void 0){wt.bindFramebuffer(k.FRAMEBUFFER,Et.__webglFramebuffer),it.copy(C.viewport),dt.copy(C.scissor),ft=C.scissorTest,wt.viewport(it),wt.scissor(dt),wt.setScissorTest(ft),J=-1;return}else if(Et.__webglFramebuffer===void 0)Xt.setupRenderTarget(C);else if(Et.__hasExternalTextures)Xt.rebindTextures(C,zt.get(C.texture).__webglTexture,zt.get(C.depthTexture).__webglTexture);else if(C.depthBuffer){let te=C.depthTexture;if(Et.__boundDepthTexture!==te){if(te!==null&&zt.has(te)&&(C.width!==te.image.width||C.height!==te.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(C)}}let It=C.texture;(It.isData3DTexture||It.isDataArrayTexture||It.isCompressedArrayTexture)&&(Tt=!0);let kt=zt.get(C).__webglFramebuffer;C.isWebGLCubeRenderTarget?(Array.isArray(kt[V])?Y=kt[V][j]:Y=kt[V],Z=!0):C.samples>0&&Xt.useMultisampledRTT(C)===!1?Y=zt.get(C).__webglMultisampledFramebuffer:Array.isArray(kt)?Y=kt[j]:Y=kt,it.copy(C.viewport),dt.copy(C.scissor),ft=C.scissorTest}else it.copy(Vt).multiplyScalar(Mt).floor(),dt.copy(he).multiplyScalar(Mt).floor(),ft=ae;if(j!==0&&(Y=z),wt.bindFramebuffer(k.FRAMEBUFFER,Y)&&wt.drawBuffers(C,Y),wt.viewport(it),wt.scissor(dt),wt.setScissorTest(ft),Z){let Et=zt.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_CUBE_MAP_POSITIVE_X+V,Et.__webglTexture,j)}else if(Tt){let Et=V;for(let It=0;It<C.textures.length;It++){let kt=zt.get(C.textures[It]);k.framebufferTextureLayer(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0+It,kt.__webglTexture,j,Et)}}else if(C!==null&&j!==0){let Et=zt.get(C.texture);k.framebufferTexture2D(k.FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Et.__webglTexture,j)}J=-1};function wr(C){let V=zt.get(C);return(V.__readFormat!==C.format||V.__readType!==C.type)&&(V.__readFormat=C.format,V.__readType=C.type,V.__formatReadable=re.textureFormatReadable(C.format),V.__typeReadable=re.textureTypeReadable(C.type)),V}this.readRenderTargetPixels=function(C,V,j,Y,Z,Tt,Pt,Et=0){if(!(C&&C.isWebGLRenderTarget)){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let It=zt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It){wt.bindFramebuffer(k.FRAMEBUFFER,It);try{let kt=C.textures[Et],te=kt.format,ue=kt.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Et);let Bt=wr(kt);if(Bt.__formatReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Bt.__typeReadable===!1){jt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}V>=0&&V<=C.width-Y&&j>=0&&j<=C.height-Z&&k.readPixels(V,j,Y,Z,_t.convert(te),_t.convert(ue),Tt)}finally{let kt=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(k.FRAMEBUFFER,kt)}}},this.readRenderTargetPixelsAsync=async function(C,V,j,Y,Z,Tt,Pt,Et=0){if(!(C&&C.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let It=zt.get(C).__webglFramebuffer;if(C.isWebGLCubeRenderTarget&&Pt!==void 0&&(It=It[Pt],Array.isArray(It)&&(It=It[0])),It)if(V>=0&&V<=C.width-Y&&j>=0&&j<=C.height-Z){wt.bindFramebuffer(k.FRAMEBUFFER,It);let kt=C.textures[Et],te=kt.format,ue=kt.type;C.textures.length>1&&k.readBuffer(k.COLOR_ATTACHMENT0+Et);let Bt=wr(kt);if(Bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let fe=k.createBuffer();k.bindBuffer(k.PIXEL_PACK_BUFFER,fe),k.bufferData(k.PIXEL_PACK_BUFFER,Tt.byteLength,k.STREAM_READ),k.readPixels(V,j,Y,Z,_t.convert(te),_t.convert(ue),0),k.bindBuffer(k.PIXEL_PACK_BUFFER,null);let $e=lt!==null?zt.get(lt).__webglFramebuffer:null;wt.bindFramebuffer(k.FRAMEBUFFER,$e);let Ce=k.fenceSync(k.SYNC_GPU_COMMANDS_COMPLETE,0);return k.flush(),await Hp(k,Ce,4),k.bindBuffer(k.PIXEL_PACK_BUFFER,fe),k.getBufferSubData(k.PIXEL_PACK_BUFFER,0,Tt),k.bindBuffer(k.PIXEL_PACK_BUFFER,null),k.deleteBuffer(fe),k.deleteSync(Ce),Tt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(C,V=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(C.image.width*Y),Tt=Math.floor(C.image.height*Y),Pt=V!==null?V.x:0,Et=V!==null?V.y:0;Xt.setTexture2D(C,0),k.copyTexSubImage2D(k.TEXTURE_2D,j,0,0,Pt,Et,Z,Tt),wt.unbindTexture()},this.copyTextureToTexture=function(C,V,j=null,Y=null,Z=0,Tt=0){let Pt,Et,It,kt,te,ue,Bt,fe,$e,Ce=C.isCompressedTexture?C.mipmaps[Tt]:C.image;if(j!==null)Pt=j.max.x-j.min.x,Et=j.max.y-j.min.y,It=j.isBox3?j.max.z-j.min.z:1,kt=j.min.x,te=j.min.y,ue=j.isBox3?j.min.z:0;else{let le=Math.pow(2,-Z);Pt=Math.floor(Ce.width*le),Et=Math.floor(Ce.height*le),C.isDataArrayTexture?It=Ce.depth:C.isData3DTexture?It=Math.floor(Ce.depth*le):It=1,kt=0,te=0,ue=0}Y!==null?(Bt=Y.x,fe=Y.y,$e=Y.z):(Bt=0,fe=0,$e=0);let Re=_t.convert(V.format),mn=_t.convert(V.type),Ut;V.isData3DTexture?(Xt.setTexture3D(V,0),Ut=k.TEXTURE_3D):V.isDataArrayTexture||V.isCompressedArrayTexture?(Xt.setTexture2DArray(V,0),Ut=k.TEXTURE_2D_ARRAY):(Xt.setTexture2D(V,0),Ut=k.TEXTURE_2D),wt.activeTexture(k.TEXTURE0),wt.pixelStorei(k.UNPACK_FLIP_Y_WEBGL,V.flipY),wt.pixelStorei(k.UNPACK_PREMULTIPLY_ALPHA_WEBGL,V.premultiplyAlpha),wt.pixelStorei(k.UNPACK_ALIGNMENT,V.unpackAlignment);let ln=wt.getParameter(k.UNPACK_ROW_LENGTH),ge=wt.getParameter(k.UNPACK_IMAGE_HEIGHT),Qi=wt.getParameter(k.UNPACK_SKIP_PIXELS),cn=wt.getParameter(k.UNPACK_SKIP_ROWS),Ar=wt.getParameter(k.UNPACK_SKIP_IMAGES);wt.pixelStorei(k.UNPACK_ROW_LENGTH,Ce.width),wt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,Ce.height),wt.pixelStorei(k.UNPACK_SKIP_PIXELS,kt),wt.pixelStorei(k.UNPACK_SKIP_ROWS,te),wt.pixelStorei(k.UNPACK_SKIP_IMAGES,ue);let Oi=C.isDataArrayTexture||C.isData3DTexture,ts=V.isDataArrayTexture||V.isData3DTexture;if(C.isDepthTexture){let le=zt.get(C),Je=zt.get(V),Vn=zt.get(le.__renderTarget),Pe=zt.get(Je.__renderTarget);wt.bindFramebuffer(k.READ_FRAMEBUFFER,Vn.__webglFramebuffer),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,Pe.__webglFramebuffer);for(let hn=0;hn<It;hn++)Oi&&(k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,zt.get(C).__webglTexture,Z,ue+hn),k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,zt.get(V).__webglTexture,Tt,$e+hn)),k.blitFramebuffer(kt,te,kt+Pt,te+Et,Bt,fe,Bt+Pt,fe+Et,k.DEPTH_BUFFER_BIT,k.NEAREST);wt.bindFramebuffer(k.READ_FRAMEBUFFER,null),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else if(Z!==0||C.isRenderTargetTexture||zt.has(C)){let le=zt.get(C),Je=zt.get(V);wt.bindFramebuffer(k.READ_FRAMEBUFFER,U),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,G);for(let Vn=0;Vn<It;Vn++)Oi?k.framebufferTextureLayer(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,le.__webglTexture,Z,ue+Vn):k.framebufferTexture2D(k.READ_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,le.__webglTexture,Z),ts?k.framebufferTextureLayer(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,Je.__webglTexture,Tt,$e+Vn):k.framebufferTexture2D(k.DRAW_FRAMEBUFFER,k.COLOR_ATTACHMENT0,k.TEXTURE_2D,Je.__webglTexture,Tt),Z!==0?k.blitFramebuffer(kt,te,kt+Pt,te+Et,Bt,fe,Bt+Pt,fe+Et,k.COLOR_BUFFER_BIT,k.NEAREST):ts?k.copyTexSubImage3D(Ut,Tt,Bt,fe,$e+Vn,kt,te,Pt,Et):k.copyTexSubImage2D(Ut,Tt,Bt,fe,kt,te,Pt,Et);wt.bindFramebuffer(k.READ_FRAMEBUFFER,null),wt.bindFramebuffer(k.DRAW_FRAMEBUFFER,null)}else ts?C.isDataTexture||C.isData3DTexture?k.texSubImage3D(Ut,Tt,Bt,fe,$e,Pt,Et,It,Re,mn,Ce.data):V.isCompressedArrayTexture?k.compressedTexSubImage3D(Ut,Tt,Bt,fe,$e,Pt,Et,It,Re,Ce.data):k.texSubImage3D(Ut,Tt,Bt,fe,$e,Pt,Et,It,Re,mn,Ce):C.isDataTexture?k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,fe,Pt,Et,Re,mn,Ce.data):C.isCompressedTexture?k.compressedTexSubImage2D(k.TEXTURE_2D,Tt,Bt,fe,Ce.width,Ce.height,Re,Ce.data):k.texSubImage2D(k.TEXTURE_2D,Tt,Bt,fe,Pt,Et,Re,mn,Ce);wt.pixelStorei(k.UNPACK_ROW_LENGTH,ln),wt.pixelStorei(k.UNPACK_IMAGE_HEIGHT,ge),wt.pixelStorei(k.UNPACK_SKIP_PIXELS,Qi),wt.pixelStorei(k.UNPACK_SKIP_ROWS,cn),wt.pixelStorei(k.UNPACK_SKIP_IMAGES,Ar),Tt===0&&V.generateMipmaps===!0&&V.mipmapsAutoUpdate===!0&&k.generateMipmap(Ut),wt.unbindTexture()},this.initRenderTarget=function(C){zt.get(C).__webglFramebuffer===void 0&&Xt.setupRenderTarget(C)},this.initTexture=function(C){C.isCubeTexture?Xt.setTextureCube(C,0):C.isData3DTexture?Xt.setTexture3D(C,0):C.isDataArrayTexture||C.isCompressedArrayTexture?Xt.setTexture2DArray(C,0):Xt.setTexture2D(C,0),wt.unbindTexture()},this.resetState=function(){q=0,H=0,lt=null,wt.reset(),bt.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return gi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=_e._getDrawingBufferColorSpace(t),e.unpackColorSpace=_e._getUnpackColorSpace()}};function fr(n){let t=new ds;return n===0||(t.onBeforeCompile=e=>{e.vertexShader=e.vertexShader.replace("#include <project_vertex>",`#include <project_vertex>
      vec4 pulled = vec4(mvPosition.xyz - normalize(mvPosition.xyz) * ${n.toExponential()}, 1.0);
      vec4 there = projectionMatrix * pulled;
      gl_Position.z = there.z / there.w * gl_Position.w;`)},t.customProgramCacheKey=()=>`nearer ${n}`),t}function fo(n,t,e,i,s,r){let o=n[e]-n[t],a=n[e+1]-n[t+1],l=n[e+2]-n[t+2],c=Math.hypot(o,a,l)||1e-12;o/=c,a/=c,l/=c;let h=Math.abs(l)<.9,[u,f,d]=h?[a,-o,0]:[0,l,-a],p=Math.hypot(u,f,d);u/=p,f/=p,d/=p,s[r]=i*u,s[r+1]=i*f,s[r+2]=i*d,s[r+4]=c*o,s[r+5]=c*a,s[r+6]=c*l,s[r+8]=i*(f*l-d*a),s[r+9]=i*(d*o-u*l),s[r+10]=i*(u*a-f*o);for(let x=0;x<3;x++)s[r+12+x]=(n[t+x]+n[e+x])/2;s[r+15]=1}var $c="#d55e00",Yc="#0072b2",Rm=["#e2cf9f","#c5bcd9","#b7cfa2","#d6aeb9","#9cc4dd","#cfcfcf"];function Pa(n){return Rm[n%Rm.length]}var DM=["#453781","#39568c","#2d708e","#20908d","#29af7f","#73d055","#b8de29","#fde725"],UM=["#00224e","#083370","#35456c","#4f576c","#666970","#7d7c78","#948e77","#aea371","#c8b866","#e5cf52","#fee838"],OM=["#ffffcc","#ffeda0","#fed976","#feb24c","#fd8c3c","#fc4d2a","#e2191c","#bb0026","#800026"];function cf(n){let t=n.map(i=>[1,3,5].map(s=>parseInt(i.slice(s,s+2),16)/255));function e(i,s=[0,0,0]){let r=Math.min(1,Math.max(0,i))*(n.length-1),o=Math.min(n.length-2,Math.floor(r));for(let a=0;a<3;a++){let l=t[o][a];s[a]=l+(r-o)*(t[o+1][a]-l)}return s}return{at:e,gradient:`linear-gradient(to right, ${n.join(", ")})`}}var po=cf(DM),Im=cf(UM),Zc=cf(OM);function Fe(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function Xs(n){let t=matchMedia("(prefers-color-scheme: dark)");return t.addEventListener("change",n),()=>t.removeEventListener("change",n)}var Pm=[[],[8,4],[8,3,2,3],[2,3]],FM=7;function _s(n){return{colour:Fe(`--line-${n%FM}`),dash:Pm[n%Pm.length]}}var BM=32767,qs=24,kM=5/3*Math.PI,zM=.22,hf=.11,Lm=.7,Nm=3,Dm=1e-6;function Um(n){let t=n.turns.map(l=>({...l,pivot:tn(l.pivot,Float32Array),axis:Float32Array.from(tn(l.axis,Int16Array),c=>c/BM),left:l.left&&tn(l.left,Float32Array)})),e=n.pushes.map(l=>({...l,force:l.force&&tn(l.force,Float32Array)})),{drives:i,stages:s}=n;function r(l){let c=s.find(({start:h,end:u})=>l>h&&l<=u);return i.map(({strength:h,rise:u},f)=>c?.drives.includes(f)?h*(u>0?Math.min(1,(l-c.start)/u):1):0)}let o=(l,c)=>l.reduce((h,u,f)=>h+u*c[f],0),a=l=>l.reduce((c,{shares:h})=>{let u=s.map(f=>Math.abs(o(h,i.map(({strength:d},p)=>f.drives.includes(p)?d:0))));return Math.max(c,...u)},0);return{...n,time:tn(n.time,Float64Array),turns:t,pushes:e,strengthsAt:r,summed:o,largestTurn:a(t),largestPush:a(e)}}function Om({drives:n,strengthsAt:t},e,i){let s=t(e);return n.flatMap(({text:r,unit:o,factor:a},l)=>s[l]?[`${r}: ${i(a*s[l])} ${o}`]:[])}function Fm(n){let{time:t,turns:e,pushes:i,strengthsAt:s,summed:r,largestTurn:o,largestPush:a}=n.efforts,l=Math.max(0,...e.map(I=>I.radius)),c=.05*n.mesh.span_m,h=fr(Math.max(l,c)),u=new li(new Wi(1,1,1,10),h,e.length*qs+i.length),f=new li(new aa(1,1,16),h,e.length+i.length),d=new Fn;for(let I of[u,f])I.frustumCulled=!1,d.add(I);let p=new Float32Array(3*(qs+2)),[x,g]=[0,0],m=(I,P,R,F,z)=>fo(p,3*P,3*R,F,I.instanceMatrix.array,16*z);function _(I,P){for(let R=0;R<3;R++)p[3*I+R]=P[R]}function w(I,P,R,F){let[z,U]=Zi(t,R),q=(I.left?uf(I.left,1,z,U)[0]:1)*r(I.shares,F)/o;if(!(Math.abs(q)>Dm))return;let[H,lt]=I.ends?VM(P,I.ends):[I.pivot,I.axis].map(ut=>uf(ut,3,z,U)),J=HM(lt,I),Q=GM(lt,J),it=kM*Math.min(1.2,Math.abs(q))*Math.sign(q),dt=ut=>H.map((gt,St)=>gt+I.radius*(Math.cos(ut)*J[St]+Math.sin(ut)*Q[St]));for(let ut=0;ut<=qs;ut++)_(ut,dt(it*(ut/qs-.5)));let ft=it/2;_(qs+1,dt(ft+Math.sign(q)*Lm));let tt=hf*I.radius;for(let ut=0;ut<qs;ut++)m(u,ut,ut+1,tt,x++);m(f,qs,qs+1,Nm*tt,g++)}function b(I,P,R,F){let[z,U]=Zi(t,R),G=I.force?uf(I.force,1,z,U)[0]:r(I.shares,F)/a;if(!(Math.abs(G)>Dm))return;let q=zM*n.mesh.span_m*G,H=P.subarray(3*I.point,3*I.point+3),lt=J=>I.direction.map((Q,it)=>H[it]+J*Q);_(0,H),_(1,lt(q)),_(2,lt(q+Math.sign(G)*Lm*c)),m(u,0,1,hf*c,x++),m(f,1,2,Nm*hf*c,g++)}function S(I){[x,g]=[0,0];let P=s(I),R=n.pointsAt(I);for(let F of e)w(F,R,I,P);for(let F of i)b(F,R,I,P);[u.count,f.count]=[x,g];for(let F of[u,f])F.instanceMatrix.needsUpdate=!0}let M=()=>h.color.set(new Qt(Fe("--effort")));function y(){for(let I of[u,f])I.dispose(),I.geometry.dispose();h.dispose()}return{group:d,pose:S,paint:M,count:()=>g,dispose:y}}function uf(n,t,e,i){if(n.length===t)return Array.from(n);let s=Math.min(e+1,n.length/t-1);return Array.from({length:t},(r,o)=>{let a=n[e*t+o];return a+i*(n[s*t+o]-a)})}function VM(n,[t,e]){let[i,s]=[t,e].map(a=>Array.from(n.subarray(3*a,3*a+3))),r=i.map((a,l)=>s[l]-a),o=Math.hypot(...r)||1;return[i.map((a,l)=>(a+s[l])/2),r.map(a=>a/o)]}function GM(n,t){return[0,1,2].map(e=>n[(e+1)%3]*t[(e+2)%3]-n[(e+2)%3]*t[(e+1)%3])}function HM(n,t){t.side??=n.map(Math.abs).reduce((r,o,a,l)=>o<l[r]-.001?a:r,2);let e=n[t.side],i=n.map((r,o)=>(o===t.side?1:0)-e*r),s=Math.hypot(...i)||1;return i.map(r=>r/s)}var xs="tendon energy";function tn(n,t){let e=atob(n),i=new Uint8Array(e.length);for(let s=0;s<e.length;s++)i[s]=e.charCodeAt(s);return new t(i.buffer)}function xi(n){let t=tn(n.time,Float64Array),e=tn(n.points,Float32Array),i=3*n.pointCount,s={[xs]:{width:n.tendonParts.length,values:tn(n.tendonEnergy_J,Float32Array)}};for(let g of n.readings)s[g.name]={width:g.parts.length,values:tn(g.values,Float32Array)};let r=Int32Array.from(n.between),o=Float64Array.from(n.share),a=new Float32Array(i);function l(g,m=a){return ff(t,e,i,g,m),m}function c(g,m=new Float32Array(3*o.length)){return h(l(g),m)}function h(g,m){for(let _=0;_<o.length;_++){let w=3*r[2*_],b=3*r[2*_+1];for(let S=0;S<3;S++){let M=g[w+S];m[3*_+S]=M+o[_]*(g[b+S]-M)}}return m}function u(g,m,_=new Float32Array(s[g].width)){return ff(t,s[g].values,s[g].width,m,_),_}function f(g,m){let{width:_,values:w}=s[g];return Float32Array.from(t,(b,S)=>w[S*_+m])}let d=tn(n.restLength_m,Float32Array);function p(g,m){d.length===m.length?m.set(d):ff(t,d,m.length,g,m)}let x=n.efforts&&Um(n.efforts);return{name:n.name,reach:Math.max(n.base.radius,x?.pushes.length?.12*n.span_m:0,...(x?.turns??[]).map(g=>.4*g.radius)),mesh:n,marks:n.marks,stages:n.stages,tendons:n.tendonParts.length,readings:n.readings,time:t,start:t[0],end:t[t.length-1],efforts:x,strained:n.built!==null,builtVertices:()=>h(tn(n.built,Float32Array),new Float32Array(3*o.length)),restLengthsAt:p,pointsAt:l,verticesAt:c,verticesOf:h,valuesAt:u,line:f,stageAt:g=>n.stages.findLast(m=>m.start<=g)??n.stages[0],markAt:g=>n.marks.find(m=>Math.abs(m.time-g)<1e-9)}}function ff(n,t,e,i,s){let[r,o]=Zi(n,i),a=r*e,l=Math.min(r+1,n.length-1)*e;for(let c=0;c<e;c++){let h=t[a+c];s[c]=o===0?h:h+o*(t[l+c]-h)}}function Zi(n,t){if(!(t>n[0]))return[0,0];let e=n.length-1;if(t>=n[e])return[e,0];let i=0,s=e;for(;s-i>1;){let r=i+s>>1;n[r]<=t?i=r:s=r}return[i,(t-n[i])/(n[i+1]-n[i])]}function Jc(){return document.getElementById("engine-program")!==null}async function Kc(n,t){let e=new Blob([tn(document.getElementById("engine-script").textContent,Uint8Array)]).stream(),i=await new Response(e.pipeThrough(new DecompressionStream("deflate"))).text(),s=URL.createObjectURL(new Blob([i],{type:"text/javascript"})),r=new Worker(s),o=new Map,a=0;r.onmessage=({data:h})=>{let u=o.get(h.to);u?(o.delete(h.to),h.said==="refused"?u.refuse(new Error(h.why)):u.take(h)):t(h)},r.onerror=h=>{h.preventDefault();let u=new Error(h.message||"the engine stopped");for(let{refuse:f}of o.values())f(u);o.clear(),t({said:"refused",why:u.message})};function l(h){let u=++a;return new Promise((f,d)=>{o.set(u,{take:f,refuse:d}),r.postMessage({...h,number:u})})}function c(){r.terminate(),URL.revokeObjectURL(s)}try{let h=document.getElementById("engine-program").textContent,{frame:u,version:f}=await l({act:"load",program:h,text:n});return{first:u,version:f,ask:l,tell:d=>r.postMessage(d),end:c}}catch(h){throw c(),h}}var Bm={type:"change"},pf={type:"start"},zm={type:"end"},jc=new Us,km=new ri,WM=Math.cos(70*$u.DEG2RAD),yn=new W,Kn=2*Math.PI,Me={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},df=1e-6,Qc=class extends ga{constructor(t,e=null){super(t,e),this.state=Me.NONE,this.target=new W,this.cursor=new W,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Vs.ROTATE,MIDDLE:Vs.DOLLY,RIGHT:Vs.PAN},this.touches={ONE:Gs.ROTATE,TWO:Gs.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new W,this._lastQuaternion=new oi,this._lastTargetPosition=new W,this._quat=new oi().setFromUnitVectors(t.up,new W(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new so,this._sphericalDelta=new so,this._scale=1,this._panOffset=new W,this._rotateStart=new Yt,this._rotateEnd=new Yt,this._rotateDelta=new Yt,this._panStart=new Yt,this._panEnd=new Yt,this._panDelta=new Yt,this._dollyStart=new Yt,this._dollyEnd=new Yt,this._dollyDelta=new Yt,this._dollyDirection=new W,this._mouse=new Yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=qM.bind(this),this._onPointerDown=XM.bind(this),this._onPointerUp=$M.bind(this),this._onContextMenu=tw.bind(this),this._onMouseWheel=JM.bind(this),this._onKeyDown=KM.bind(this),this._onTouchStart=jM.bind(this),this._onTouchMove=QM.bind(this),this._onMouseDown=YM.bind(this),this._onMouseMove=ZM.bind(this),this._interceptControlDown=ew.bind(this),this._interceptControlUp=nw.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Me.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Bm),this.update(),this.state=Me.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;yn.copy(e).sub(this.target),yn.applyQuaternion(this._quat),this._spherical.setFromVector3(yn),this.autoRotate&&this.state===Me.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Kn:i>Math.PI&&(i-=Kn),s<-Math.PI?s+=Kn:s>Math.PI&&(s-=Kn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(yn.setFromSpherical(this._spherical),yn.applyQuaternion(this._quatInverse),e.copy(this.target).add(yn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=yn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new W(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new W(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=yn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(jc.origin.copy(this.object.position),jc.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(jc.direction))<WM?this.object.lookAt(this.target):(km.setFromNormalAndCoplanarPoint(this.object.up,this.target),jc.intersectPlane(km,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>df||8*(1-this._lastQuaternion.dot(this.object.quaternion))>df||this._lastTargetPosition.distanceToSquared(this.target)>df?(this.dispatchEvent(Bm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?Kn/60*this.autoRotateSpeed*t:Kn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){yn.setFromMatrixColumn(e,0),yn.multiplyScalar(-t),this._panOffset.add(yn)}_panUp(t,e){this.screenSpacePanning===!0?yn.setFromMatrixColumn(e,1):(yn.setFromMatrixColumn(e,0),yn.crossVectors(this.object.up,yn)),yn.multiplyScalar(t),this._panOffset.add(yn)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;yn.copy(s).sub(this.target);let r=yn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Kn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Kn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(Kn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-Kn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(Kn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-Kn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(Kn*this._rotateDelta.x/e.clientHeight),this._rotateUp(Kn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new Yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function XM(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function qM(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function $M(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(zm),this.state=Me.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function YM(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Vs.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Me.DOLLY;break;case Vs.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}break;case Vs.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Me.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Me.PAN}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(pf)}function ZM(n){switch(this.state){case Me.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Me.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Me.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function JM(n){this.enabled===!1||this.enableZoom===!1||this.state!==Me.NONE||(n.preventDefault(),this.dispatchEvent(pf),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(zm))}function KM(n){this.enabled!==!1&&this._handleKeyDown(n)}function jM(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Gs.ROTATE:if(this.enableRotate===!1){this.state=Me.NONE;break}this._handleTouchStartRotate(n),this.state=Me.TOUCH_ROTATE;break;case Gs.PAN:if(this.enablePan===!1){this.state=Me.NONE;break}this._handleTouchStartPan(n),this.state=Me.TOUCH_PAN;break;default:this.state=Me.NONE}break;case 2:switch(this.touches.TWO){case Gs.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Me.TOUCH_DOLLY_PAN;break;case Gs.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Me.TOUCH_DOLLY_ROTATE;break;default:this.state=Me.NONE}break;default:this.state=Me.NONE}this.state!==Me.NONE&&this.dispatchEvent(pf)}function QM(n){switch(this._trackPointer(n),this.state){case Me.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Me.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Me.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Me.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Me.NONE}}function tw(n){this.enabled!==!1&&n.preventDefault()}function ew(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function nw(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var mf=120,Vm=2,Gm=6;function gf(n,t,e){let i=new WeakMap,s=t.reduce((l,c)=>n[c].mesh.tubes.reduce((h,u)=>Math.max(h,u.radius),Math.max(l,n[c].reach)),Math.max(...t.map(l=>n[l].mesh.joints.length?n[l].mesh.jointRadius:0))),r=null;function o(){let{span:l}=e;if(!i.has(l)){let c=Array.from({length:mf+1},(h,u)=>e.timeAt(u/mf));i.set(l,c.map(h=>t.map(u=>n[u].pointsAt(e.clipTime(u,h)).slice())))}return i.get(l)}function a(l,c){let h=[...l.flatMap(f=>f.toArray()),...c].join();if(r?.key===h&&r.span===e.span)return r;let u=o().map(f=>iw(f,l,c,s));return r={key:h,span:e.span,rows:sw(u),whole:Hm(u)},r}return function(c,h,u,f){let d=new W().crossVectors(h,c).normalize(),p=[d,new W().crossVectors(c,d),c],{rows:x,whole:g}=a(p,u),m=f?rw(x,e.wayAt(e.time)*mf):g,[_,w,b,S,M,y]=m,T=[(_-w)/2,(b-S)/2,(M-y)/2],I=Math.max((_+w)/(2*u[0]),(b+S)/(2*u[1])),P=new W;for(let[R,F]of p.entries())P.addScaledVector(F,T[R]);return{target:P,distance:I-T[2]||1}}}function iw(n,t,e,i){let s=new Float64Array(Gm).fill(-1/0),r=e.map(u=>i*Math.hypot(1,u)),o=[r[0],r[0],r[1],r[1],0,0],[a,l,c]=t.map(u=>u.toArray()),h=(u,f,d)=>u[0]*f[d]+u[1]*f[d+1]+u[2]*f[d+2];for(let u of n)for(let f=0;f<u.length;f+=3){let[d,p,x]=[h(a,u,f),h(l,u,f),h(c,u,f)],[g,m]=[e[0]*x,e[1]*x],_=[d+g,g-d,p+m,m-p,x,-x];for(let w=0;w<Gm;w++)_[w]>s[w]&&(s[w]=_[w])}return s.map((u,f)=>u+o[f])}function Hm(n){return n.reduce((t,e)=>t.map((i,s)=>Math.max(i,e[s])))}function sw(n){let t=(i,s)=>i.slice(Math.max(0,s-Vm),s+Vm+1),e=n.map((i,s)=>Hm(t(n,s)));return n.map((i,s)=>{let r=t(e,s);return r[0].map((o,a)=>r.reduce((l,c)=>l+c[a],0)/r.length)})}function rw(n,t){let e=Math.min(n.length-2,Math.max(0,Math.floor(t))),i=Math.min(1,Math.max(0,t-e));return n[e].map((s,r)=>s+i*(n[e+1][r]-s))}var Wm=28,ow=1.05,Xm=Math.PI/24,aw=1.15,dr=[{name:"3-D",text:"obliquely from above",towards:[.37,-.695,.616]},{name:"top",text:"from above",towards:[0,-5e-4,1]},{name:"side",text:"from the side, level with what lies flat",towards:[0,-1,1e-4]},{name:"along",text:"from the far end, along the middle",towards:[1,0,1e-4]}];function qm(n,t,e,i,s=Ia()){let{size:r,target:o}=lw(t),a=t.map((S,M)=>M),l=gf(t,a,e),c=a.map(S=>gf(t,[S],e)),h=new Xn(Wm,1,.02*r,60*r);h.up.set(0,0,1);let u=new Qc(h,n);u.minDistance=.1*r,u.maxDistance=20*r;let f=null;function d(S=0){let M=s.oneScale?l:c[S],y=Math.tan(Wm*Math.PI/360)/ow;f=M(s.towards,h.up,[y*h.aspect,y],s.following),s.oneScale&&(f.distance*=s.scale),u.target.copy(f.target).addScaledVector(s.aside,f.distance),h.position.copy(u.target).addScaledVector(s.towards,s.closer*f.distance),h.lookAt(u.target),h.updateMatrixWorld()}function p(){d(),i()}u.addEventListener("change",()=>{let S=h.position.clone().sub(u.target);s.closer=S.length()/f.distance,s.towards.copy(S).normalize(),s.aside.copy(u.target).sub(f.target).divideScalar(f.distance),p()});let x=S=>{document.activeElement!==n&&!S.ctrlKey&&S.stopImmediatePropagation()};n.parentElement.addEventListener("wheel",x,{capture:!0});function g({towards:S}){s.towards.set(...S).normalize(),s.closer=1,s.aside.set(0,0,0),p()}function m(S,M){let y=s.towards.clone().applyAxisAngle(h.up,S*Xm),T=new W().crossVectors(h.up,y).normalize(),I=y.clone().applyAxisAngle(T,-M*Xm);s.towards.copy(Math.abs(I.z)<.9999?I:y),p()}function _(S){let M=s.closer*f.distance*aw**-S;s.closer=Math.min(u.maxDistance,Math.max(u.minDistance,M))/f.distance,p()}function w(S){Object.assign(s,S),p()}function b(S,M){h.aspect=S,h.updateProjectionMatrix(),u.rotateSpeed=M,u.panSpeed=M,p()}return{camera:h,controls:u,look:s,size:r,target:o,aim:d,show:g,turn:m,zoom:_,choose:w,resize:b,dispose:()=>u.dispose()}}function Ia(){return{towards:new W(...dr[0].towards).normalize(),closer:1,aside:new W,following:!0,oneScale:!0,scale:1}}function lw(n){let t=new W(1/0,1/0,1/0),e=new W(-1/0,-1/0,-1/0),i=new W;for(let r of n){let o=Math.max(1,Math.floor(r.time.length/60));for(let a=0;a<r.time.length;a+=o){let l=r.pointsAt(r.time[a]);for(let c=0;c<l.length;c+=3)i.fromArray(l,c),t.min(i),e.max(i)}}let s=t.clone().add(e).multiplyScalar(.5);return{target:s,size:e.distanceTo(s)||1}}function Rn(n){return`${n[0]?.toUpperCase()??""}${n.slice(1)}`}function Nn(n,t){let e=n.toFixed(t);return(Number(e)===0?0 .toFixed(t):e).replace("-","−")}function Te(n){let t=Number(n.toPrecision(4)),e=Math.abs(t);return(e!==0&&(e>=1e5||e<.001)?n.toExponential(2):String(t)).replaceAll("-","−")}function La(n){let t=Math.max(Math.abs(n.start),Math.abs(n.end));return t>=.2?{unit:"s",factor:1}:t>=2e-4?{unit:"ms",factor:1e3}:{unit:"µs",factor:1e6}}function pr(n,t){let{unit:e,factor:i}=La(t),s=Math.ceil(2.7-Math.log10(i*(t.end-t.start)));return`${Nn(i*n,Math.min(6,Math.max(0,s)))} ${e}`}var Na=1/0,cw={m:1,cm:100,mm:1e3,µm:1e6};function $m(n,t,e){let i=new Set,s=n.readings.map(({unit:d})=>d==="deg"?180/Math.PI:t.units.length*cw[d]),r={start:n.start,end:Math.max(n.end,n.start+1),origins:[0],whole:!0},o=e,a=0;function l(){a||=requestAnimationFrame(()=>{a=0;for(let d of i)d()})}let c=(d,p)=>d!==Na?n.pointsAt(d,p):p?(p.set(o.points),p):o.points,h={...n,marks:[],efforts:null,reach:n.mesh.base.radius,pointsAt:c,verticesAt:(d,p)=>d===Na?n.verticesOf(o.points,p):n.verticesAt(d,p),valuesAt(d,p,x){if(p!==Na)return n.valuesAt(d,p,x);let g=n.readings.findIndex(_=>_.name===d),m=d===xs?o.energies_J:o.readings[g].map(_=>s[g]*_);return x?(x.set(m),x):Float32Array.from(m)},restLengthsAt(d,p){d===Na?p.set(o.restLengths_m):n.restLengthsAt(d,p)},markAt:()=>{}},u={get time(){return o.time_s},span:r,clipTime:(d,p=Na)=>p,timeAt:d=>r.start+d*(r.end-r.start),wayAt:()=>0,onChange(d){return i.add(d),l(),()=>i.delete(d)}};function f(d){o=d,l()}return{clip:h,clock:u,show:f,get frame(){return o}}}var hw=[["space","play or pause"],["← →","a little back or on"],["page down, page up","further back or on"],["home, end","start, end"]],uw="shift with ← → ↑ ↓",fw=[["+ −","nearer, further"],["0","the first view again"]];function th(n,t,e){let s=(n.length===1?n[0].marks:[]).map((o,a)=>[String(a+1),o.name]),r=[...hw,...s,...t?[[uw,`turn the ${e}`],...fw]:[]].map(([o,a])=>D("tr",{},D("th",{scope:"row"},o),D("td",{},a)));return D("details",{className:"keys"},D("summary",{},"Keys"),D("table",{},D("tbody",{},...r)),D("p",{},"Space and arrows act wherever nothing else on the page has the keys, the others in the player."))}var Ym={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Zm({key:n,shiftKey:t},e,i,s){if(t&&n in Ym)e?.turn(...Ym[n]);else if(s)if(n==="+"||n==="=")e?.zoom(1);else if(n==="-"||n==="−")e?.zoom(-1);else if(n==="0")e?.show(i);else return!1;else return!1;return!0}function Jm(n,t,e){n.addEventListener("keydown",i=>{!i.ctrlKey&&!i.metaKey&&!i.altKey&&Zm(i,t,e,!0)&&i.preventDefault()})}function eh(n,t,e,i,s){let r={ArrowLeft:-1,ArrowRight:1,PageUp:10,PageDown:-10};function o(c){e.pause(),c()}function a(c,h){let{key:u}=c;if(Zm(c,i,s,h))return!0;if(u in r)o(()=>e.step(r[u]));else if(u===" ")e.playing?e.pause():e.play();else if(u==="Home")o(()=>e.seek(e.span.start));else if(u==="End")o(()=>e.seek(e.span.end));else if(h)if(t.length===1&&t[0].marks[Number(u)-1])o(()=>e.seekClip(0,t[0].marks[Number(u)-1].time));else return!1;else return!1;return!0}function l(c){let h=document.activeElement,u=n.contains(h);!(u||h===document.body||h===null)||c.ctrlKey||c.metaKey||c.altKey||h instanceof HTMLSelectElement||h?.dataset?.keys==="own"||c.key===" "&&/^(BUTTON|SUMMARY|A)$/.test(h?.tagName??"")||h===document.body&&/^(Home|End|PageUp|PageDown)$/.test(c.key)||a(c,u)&&c.preventDefault()}return document.addEventListener("keydown",l),()=>document.removeEventListener("keydown",l)}var Km=2.4;function Da(n){let t=10**Math.floor(Math.log10(n/Km));return t*[5,2,1].find(e=>e*t<=n/Km)}function jm(n,t){let e=Da(n),i=e*Math.ceil(1.25*n/e),s=[],[r,o]=[t.x,t.y].map(c=>e*Math.round(c/e));for(let c=-i;c<=i+e/2;c+=e)s.push(r+c,o-i,0,r+c,o+i,0,r-i,o+c,0,r+i,o+c,0);let a=new gn().setAttribute("position",new Qe(s,3)),l=new or(a,new Fs({transparent:!0,opacity:.5,depthWrite:!1}));return l.frustumCulled=!1,l}function _f(n,t,e,i){let s=i?["marks on the time line: the states of each run, in its colour"]:[];return D("ul",{className:"legend"},...n.map(({sample:r,text:o})=>r==="tendon"?pw(o,t):dw(r,o)),...n.some(({sample:r})=>r==="tendon")?[D("li",{},"slack tendons hang, drawn with their resting length")]:[],D("li",{},`squares of the grid: ${mw(Da(e))}`),...s.map(r=>D("li",{},r)))}function dw(n,t){let[e,i]=n.split(" "),s={mountain:{color:$c},valley:{color:Yc},region:{background:Pa(i)}};return D("li",{className:e==="region"?"of-region":""},Qm(e==="region"?"panel":e,s[e]??{}),t)}function pw(n,t){let e=D("li",{className:"energy"},`${n}: 0`,xf(po));return e.append(`${Te(t.factor*t.largest_J)} ${t.unit}`),e}function xf(n){return Qm("bar",{background:n.gradient})}function Qm(n,t){let e=D("span",{className:`swatch ${n}`,"aria-hidden":"true"});return Object.assign(e.style,t),e}function mw(n){let[t,e]=n>=1?["m",1]:n>=.01?["cm",100]:n>=1e-4?["mm",1e3]:["µm",1e6];return`${Te(e*n)} ${t}`}function tg(n,t){if(!(t>n*(1+1e-6)))return 0;let[e,i]=[0,t/2];for(let s=0;s<40;s++){let r=(e+i)/2;gw(n,r)<t?e=r:i=r}return(e+i)/2}function gw(n,t){return t===0?n:Math.hypot(n,4*t)/2+n*n*Math.asinh(4*t/(n||1e-12))/(8*t)}function ng(n){let{triangles:t,faces:e}=n.mesh,i=n.builtVertices(),s=Array.from({length:e.length},(c,h)=>eg(i,t,h)),r=new Float32Array(e.reduce((c,h)=>Math.max(c,h),0)+1),o=new Float32Array(e.length);function a(c){r.fill(-1/0);for(let h=0;h<e.length;h++){let[u,f,d]=s[h],p=u*d-f*f;if(p<=1e-9*(u+d)**2)continue;let[x,g,m]=eg(c,t,h),_=(d*x-2*f*g+u*m)/(2*p),w=(x*m-g*g)/p,b=(_+Math.sqrt(Math.max(_*_-w,0))-1)/2;r[e[h]]=Math.max(r[e[h]],b)}for(let h=0;h<e.length;h++)o[h]=Math.max(0,r[e[h]]);return o}function l(){let c=new Float32Array(i.length),h=0;for(let u of n.time)h=a(n.verticesAt(u,c)).reduce((f,d)=>Math.max(f,d),h);return h}return{at:a,largest:l}}function eg(n,t,e){let[i,s,r]=[0,1,2].map(c=>3*t[3*e+c]),[o,a,l]=[0,0,0];for(let c=0;c<3;c++){let h=n[s+c]-n[i+c],u=n[r+c]-n[i+c];o+=h*h,a+=h*u,l+=u*u}return[o,a,l]}var _w=.9,ig=.4,xw=.02,yw=["crease","rim","edge"],$s=12;function yf(n,t){let{mesh:e}=n,i=new Float32Array(3*e.share.length),s=new Float32Array(n.tendons),r=Math.max(0,...e.tubes.map(I=>I.radius)),[o,a]=[!1,!0].map(I=>bw(e,I)),l=sg(e.tubes.filter(I=>I.kind==="bar"),20,0),c=sg(e.tubes.filter(I=>yw.includes(I.kind)),8,.4*r),h=Sw(n,2.4*r),u=ww(e.base),f=n.efforts?Fm(n):null,d=n.strained?ng(n):null,p=0,x=Aw(e),g=new Fn;g.add(u.object,a.object,l.object,x.object,c.object,h.object,o.object),f&&g.add(f.group);let m=vw(o.object,a.object,l.object),_=[0,0,0],w=new Qt;function b(I){n.verticesAt(I,i),o.pose(i),a.pose(i);for(let R of[l,c,x])R.pose(i);n.valuesAt(xs,I,s);let P=s.map(R=>t>0?R/t:0);h.pose(i,I,R=>ig+(1-ig)*Math.min(1,Math.max(0,P[R])/xw));for(let R=0;R<n.tendons;R++)po.at(P[R],_),h.colour(R,w.setRGB(..._,"srgb"));n.tendons&&(h.object.instanceColor.needsUpdate=!0),f?.pose(I),p&&S()}function S(){let I=d.at(i),P=[0,0,0];for(let R of[o,a])R.colour(F=>w.setRGB(...Zc.at(I[F]/p,P),"srgb"))}function M(I){p=d?I:0;for(let P of[o,a])P.flat(p>0),p||P.colour(R=>w.set(Pa(e.regions[R])));p&&S()}function y(){for(let I of[l,c,x,u])I.paint();f?.paint(),m.children[0].material.color.set(Fe("--shadow"))}function T(){for(let I of[l,c,h,x])I.object.dispose();for(let I of[o,a])I.dispose();f?.dispose(),u.dispose();for(let I of[l,c,h,x])I.object.geometry.dispose(),I.object.material.dispose();m.children[0].material.dispose()}return{group:g,shadow:m,pose:b,paint:y,sort:o.sort,vertices:i,tendons:h.object,efforts:f,strains:d,showStrain:M,dispose:T}}function vw(...n){let t=new rr({side:Bn,transparent:!0,opacity:.12,depthWrite:!1,stencilWrite:!0,stencilRef:1,stencilFunc:Bu,stencilZPass:Fu}),e=new Fn;for(let i of n){let s=i.isInstancedMesh?new li(i.geometry,t,i.count):new Ln(i.geometry,t);i.isInstancedMesh&&(s.instanceMatrix=i.instanceMatrix),s.frustumCulled=!1,e.add(s)}return e.scale.z=1e-5,e}function bw(n,t){let e=n.regions.flatMap((b,S)=>n.solid[b]===t?[S]:[]),i=e.flatMap(b=>n.triangles.slice(3*b,3*b+3)),s=e.length,r=new sn(new Float32Array(3*i.length),3).setUsage(Aa),o=new sn(new Float32Array(3*i.length),3).setUsage(Aa),a=new sn(new Uint32Array(i.length),1).setUsage(Aa);for(let b=0;b<i.length;b++)a.array[b]=b;let l=new gn;l.setAttribute("position",r),l.setAttribute("color",o),l.setIndex(a);let c=new ds({vertexColors:!0,side:Bn,flatShading:!0,transparent:!t,opacity:t?1:_w,depthWrite:t,forceSinglePass:!0});c.onBeforeCompile=b=>{b.fragmentShader=b.fragmentShader.replace("#include <color_fragment>",`#include <color_fragment>
if (!gl_FrontFacing) diffuseColor.rgb *= 0.84;`)};let h=new rr({vertexColors:!0,side:Bn}),u=new Ln(l,c);u.frustumCulled=!1,u.renderOrder=t?0:1;let f=new Qt;d(b=>f.set(Pa(n.regions[b])));function d(b){for(let[S,M]of e.entries()){let y=b(M);for(let T=0;T<3;T++)y.toArray(o.array,9*S+3*T)}o.needsUpdate=!0}let p=b=>{u.material=b?h:c};function x(){l.dispose(),c.dispose(),h.dispose()}function g(b){for(let S=0;S<i.length;S++)for(let M=0;M<3;M++)r.array[3*S+M]=b[3*i[S]+M];r.needsUpdate=!0}let m=new Float32Array(s),_=Array.from({length:s},(b,S)=>S);function w(b){let S=r.array;for(let M=0;M<s;M++){let y=0;for(let T=0;T<3;T++){let I=9*M+T;y+=((S[I]+S[I+3]+S[I+6])/3-b.getComponent(T))**2}m[M]=y}_.sort((M,y)=>m[y]-m[M]);for(let M=0;M<s;M++)for(let y=0;y<3;y++)a.array[3*M+y]=3*_[M]+y;a.needsUpdate=!0}return{object:u,pose:g,sort:w,colour:d,flat:p,dispose:x}}function sg(n,t,e){let i=new li(new Wi(1,1,1,t),fr(e),n.length);i.frustumCulled=!1,o();let s=n.map(a=>[3*a.ends[0],3*a.ends[1],a.radius]);function r(a,l=()=>1){let c=i.instanceMatrix.array;for(let[h,[u,f,d]]of s.entries())fo(a,u,f,l(h)*d,c,16*h);i.instanceMatrix.needsUpdate=!0}function o(){let a={M:new Qt($c),V:new Qt(Yc),B:new Qt(Fe("--bar"))};for(let[l,c]of n.entries())i.setColorAt(l,a[c.crease]);n.length&&(i.instanceColor.needsUpdate=!0)}return{object:i,pose:r,paint:o}}function Sw(n,t){let e=n.mesh.tubes.filter(l=>l.kind==="tendon"),i=new li(new Wi(1,1,1,12),fr(t),e.length*$s);i.frustumCulled=!1;let s=new Float32Array(e.length),r=new Float32Array(3*($s+1));function o(l,c,h){n.restLengthsAt(c,s);let u=i.instanceMatrix.array;for(let[f,{ends:d,radius:p}]of e.entries()){Mw(l,3*d[0],3*d[1],s[f],r);for(let x=0;x<$s;x++)fo(r,3*x,3*x+3,h(f)*p,u,16*(f*$s+x))}i.instanceMatrix.needsUpdate=!0}function a(l,c){for(let h=0;h<$s;h++)i.setColorAt(l*$s+h,c)}return{object:i,pose:o,colour:a}}function Mw(n,t,e,i,s){let r=[0,1,2].map(f=>n[e+f]-n[t+f]),o=Math.hypot(...r),a=tg(o,i),l=Math.abs(r[2])>.999*o?[1,0,0]:[0,0,-1],c=l.reduce((f,d,p)=>f+d*r[p],0)/(o*o||1),h=l.map((f,d)=>f-c*r[d]),u=Math.hypot(...h)||1;for(let f=0;f<=$s;f++){let d=f/$s,p=4*a*d*(1-d)/u;for(let x=0;x<3;x++)s[3*f+x]=n[t+x]+d*r[x]+p*h[x]}}function ww({rods:n,radius:t}){let e=new Float32Array(n.flat(2)),i=fr(0),s=new li(new Wi(1,1,1,16),i,n.length),r=new li(new no(1,16,12),i,2*n.length),o=new Fn;for(let l of[s,r])l.frustumCulled=!1,o.add(l);for(let l=0;l<n.length;l++)fo(e,6*l,6*l+3,t,s.instanceMatrix.array,16*l);for(let l=0;l<2*n.length;l++){let c=r.instanceMatrix.array;for(let h=0;h<3;h++)[c[16*l+5*h],c[16*l+12+h]]=[t,e[3*l+h]];c[16*l+15]=1}function a(){for(let l of[s,r])l.dispose(),l.geometry.dispose();i.dispose()}return{object:o,paint:()=>i.color.set(Fe("--base")),dispose:a}}function Aw(n){let t=new li(new no(1,16,12),fr(0),n.joints.length);t.frustumCulled=!1;let e=()=>t.material.color.set(Fe("--joint"));e();function i(s){let r=t.instanceMatrix.array;for(let[o,a]of n.joints.entries()){for(let l=0;l<3;l++)r[16*o+5*l]=n.jointRadius,r[16*o+12+l]=s[3*a+l];r[16*o+15]=1}t.instanceMatrix.needsUpdate=!0}return{object:t,pose:i,paint:e}}var Tw=4096,Ew=3.2,Cw=new W(-.45,.75,1),Rw=.42*Math.PI,Pw=.64*Math.PI,Iw=.5,Lw=.14;function Ua(n,t,e,i,s){let r=D("canvas",{tabIndex:0,role:"img","aria-label":`${i} ${Nw}`}),o=r.getContext("webgl2",{antialias:!0,alpha:!0,stencil:!0});if(!o)return null;let a=n.map(()=>D("div",{className:"cell"})),l=n.length>1,c=D("div",{className:l?"stage several":"stage"},r,...a);c.style.setProperty("--columns",String(n.length===4?2:Math.min(n.length,n.length>6?4:3)));let h=()=>l?Math.ceil(Ew*parseFloat(getComputedStyle(a[0]).fontSize)):0,u=new Wc({canvas:r,context:o,antialias:!0,alpha:!0,stencil:!0});u.setScissorTest(!0);let f=qm(r,n,t,g,s),d=n.map(P=>Dw(P,e(P),f)),p=0,x=!1;function g(){p||(p=requestAnimationFrame(_))}function m(){for(let[P,R]of d.entries())R.shape.pose(t.clipTime(P));x=!0}function _(){cancelAnimationFrame(p),p=0,x||m();let P=r.clientHeight,R=h();u.setScissor(0,0,r.clientWidth,P),u.setViewport(0,0,r.clientWidth,P),u.clear();for(let[F,z]of d.entries()){f.aim(F);let U=a[F],G=[U.offsetLeft,P-U.offsetTop-U.offsetHeight,U.offsetWidth,U.offsetHeight-R];u.setViewport(...G),u.setScissor(...G),z.light.position.copy(Cw).applyQuaternion(f.camera.quaternion);let q=f.camera.position.z>z.floor.position.z;z.floor.material.opacity=q?Iw:Lw,z.shape.shadow.visible=q,z.shape.sort(f.camera.position),u.render(z.scene,f.camera)}f.aim()}function w(){for(let P of d)P.floor.material.color.set(Fe("--floor")),P.shape.paint();g()}function b(){let[P,R]=[c.clientWidth,c.clientHeight];if(!P||!R)return;u.setPixelRatio(Math.min(devicePixelRatio,2,Tw/Math.max(P,R))),u.setSize(P,R,!1);let F=a[0].offsetHeight-h();f.resize(a[0].offsetWidth/F,R/F),_()}let S=new ResizeObserver(b);S.observe(c);let M=t.onChange(()=>{x=!1,_()}),y=Xs(w);r.addEventListener("webglcontextrestored",g),w();function T(){cancelAnimationFrame(p),M(),y(),S.disconnect(),f.dispose();for(let{shape:P,floor:R}of d)P.dispose(),R.geometry.dispose(),R.material.dispose();u.dispose(),u.forceContextLoss(),c.remove()}function I(P){let R=P?d.reduce((F,{shape:z})=>Math.max(F,z.strains?.largest()??0),0):0;for(let{shape:F}of d)F.showStrain(R||(P?Number.MIN_VALUE:0));return g(),R}return{element:c,canvas:r,cells:a,eye:f,pose:m,draw:_,views:d,showStrain:I,statistics:()=>u.info.render,dispose:T}}var Nw="Drag to turn it, pinch to zoom; keys are listed below.";function Dw(n,t,e){let i=jm(e.size,e.target);i.position.z=Uw(n)-.06*e.size,t.shadow.position.z=i.position.z+.001*e.size;let s=new pa("#ffffff",Rw),r=new Qo;return r.add(t.group,t.shadow,i,s,new ua("#ffffff","#dde2e8",Pw)),{shape:t,floor:i,light:s,scene:r}}function Uw(n){let t=1/0,e=Math.max(1,Math.floor(n.time.length/200));for(let i=0;i<n.time.length;i+=e){let s=n.pointsAt(n.time[i]);for(let r=2;r<s.length;r+=3)t=Math.min(t,s[r])}return t}var Ow=.3,Fw=4,Bw=4,og=[{name:"even motion",value:"even"},{name:"real time",value:1},{name:"1/2",value:1/2},{name:"1/5",value:1/5},{name:"1/10",value:1/10},{name:"1/20",value:1/20},{name:"1/50",value:1/50},{name:"1/100",value:1/100}];function ag(n,t){let e=kw(n,t),i=new Float64Array(e.length);for(let[l,c]of n.entries())zw(c,t.origins[l],e,i);for(let l=1;l<i.length;l++)i[l]+=i[l-1];let s=i[i.length-1],r=s>0?Ow:1;for(let l=0;l<i.length;l++){let c=(e[l]-e[0])/(e[e.length-1]-e[0]||1);i[l]=r*c+(1-r)*(i[l]/(s||1))}let o=l=>l.drive!=="none"&&l.start-t.origins[0]<t.end&&l.end-t.origins[0]>t.start,a=n[0].stages.filter(o).length;return{seconds:Fw+Bw*a,wayAt:l=>rg(e,i,l),timeAt:l=>rg(i,e,l)}}function kw(n,t){let e=new Set([t.start,t.end]);for(let[i,s]of n.entries())for(let r of s.time){let o=r-t.origins[i];o>t.start&&o<t.end&&e.add(o)}return Float64Array.from(e).sort()}function zw(n,t,e,i){let s=n.pointsAt(e[0]+t).slice(),r=s.slice();for(let o=1;o<e.length;o++){n.pointsAt(e[o]+t,r);let a=0;for(let l=0;l<r.length;l+=3){let c=Math.hypot(r[l]-s[l],r[l+1]-s[l+1],r[l+2]-s[l+2]);c>a&&(a=c)}i[o]=Math.max(i[o],a),[s,r]=[r,s]}}function rg(n,t,e){let[i,s]=Zi(n,e);return s===0?t[i]:t[i]+s*(t[i+1]-t[i])}var Vw="M7 4.5v15l12-7.5z",Gw="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",vf=1e4;function nh(n,t){let e=D("button",{type:"button",className:"play"}),i=D("input",{type:"range",min:0,max:vf,step:1,"aria-label":"time"}),s=D("div",{className:"bands","aria-hidden":"true"}),r=D("div",{className:"ticks","aria-hidden":"true"}),o=D("p",{className:"time"}),a=D("p",{className:"spoken",role:"status"}),l=n.length===1?n[0].marks.map(d=>Hw(d,t)):[],c=D("div",{className:"transport"},D("div",{className:"line"},e,D("div",{className:"track"},s,i,r)),D("div",{className:"choices"},o,...l.length?[D("div",{className:"states"},...l)]:[],Ww(t),...Xw(t),a));e.addEventListener("click",()=>t.playing?t.pause():t.play()),i.addEventListener("input",()=>{t.pause(),t.seek(t.momentAt(i.value/vf))});let h=null,u=null,f=0;return t.onChange(()=>{let d=`${t.spans.indexOf(t.span)} ${t.stretched}`;d!==h&&qw(n,t,s,r),h=d,i.value=Math.round(vf*t.shareAt(t.time)),i.setAttribute("aria-valuetext",lg(n,t));let p=n.length===1?` · ${ih(n[0],t.clipTime(0))}`:t.span.label.replace("time",""),x=t.playing?`, ${$w(t.slowness)}`:"";o.textContent=`${pr(t.time,t.span)}${p}${x}`;for(let[g,m]of(n.length===1?n[0].marks:[]).entries())l[g].setAttribute("aria-pressed",String(Math.abs(m.time-t.clipTime(0))<1e-9));t.playing!==u&&(e.replaceChildren(Za(t.playing?Gw:Vw)),e.setAttribute("aria-label",t.playing?"pause":"play"),u=t.playing),clearTimeout(f),t.playing||(f=setTimeout(()=>{a.textContent=lg(n,t)},600))}),c}function Hw(n,t){let e=D("button",{type:"button",className:"state"},D("b",{},n.letter),` ${n.name}`);return e.addEventListener("click",()=>{t.pause(),t.seekClip(0,n.time)}),e}function Ww(n){let t=og.map(({name:i,value:s})=>D("option",{value:String(s)},i)),e=D("select",{},...t);return e.addEventListener("change",()=>n.setSpeed(e.value==="even"?"even":Number(e.value))),D("label",{},"speed ",e)}function Xw(n){if(n.spans.length<2)return[];let t=n.spans.map((i,s)=>D("option",{value:String(s)},i.name)),e=D("select",{},...t);return e.addEventListener("change",()=>n.setSpan(n.spans[Number(e.value)])),n.onChange(()=>{e.value=String(n.spans.indexOf(n.span))}),[D("label",{},"show ",e)]}function qw(n,t,e,i){let{span:s}=t,r=o=>Math.min(1,Math.max(0,t.shareAt(o)));e.replaceChildren(),i.replaceChildren();for(let[o,a]of n.entries()){let l=s.origins[o];for(let c of a.stages.filter(h=>h.driven&&n.length===1)){let[h,u]=[r(c.start-l),r(c.end-l)],f=D("span",{className:"band"});f.style.left=`${100*h}%`,f.style.width=`${100*(u-h)}%`,u>h&&e.append(f)}for(let c of a.marks){let h=c.time-l;if(h<s.start-1e-9||h>s.end+1e-9)continue;let u=D("span",{className:"tick"},n.length===1?c.letter:"");u.style.left=`${100*r(h)}%`,n.length>1&&u.style.setProperty("--tick",`var(--line-${o%7})`),i.append(u)}}}function $w(n){return n<1.05?"real time":`${n<10?Nn(n,1):Math.round(n)} times slower`}function ih(n,t){let e=n.markAt(t);return e?`${e.letter} ${e.name}`:n.stageAt(t).name}function lg(n,t){let e=n.map((i,s)=>{let r=t.clipTime(s);return`${n.length>1?`${i.name}: `:""}${ih(i,r)}${Yw(i,r)}`});return`${pr(t.time,t.span)}: ${e.join("; ")}`}function Yw(n,t){let[e]=n.readings;if(!e)return"";let i=n.markAt(t)?.readings[e.name]?.mean??n.valuesAt(e.name,t),s=e.unit==="deg"?"degrees":e.unit,r=[Math.min(...i),Math.max(...i)].map(a=>Nn(a,1)),o=i.length>1;return`, ${e.label}${o?"s":""} ${o?r.join(" to "):r[0]} ${s}`}function mo(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ua(t,e,d=>yf(d,i.largest_J),r,a),c=l?D("div",{className:"picture"},l.element,oh(l.eye,t.length>1||a?o:null)):D("p",{className:"note"},rh(o));l&&t.length===1&&Zw(l.cells[0],t[0],e);let h=l?[_f(s,i,l.eye.size,t.length>1?o:null)]:[];l&&t.some(d=>d.strained)&&h.unshift(hg(l,h[0])),l&&t.length===1&&t[0].efforts?.drives.length&&Jw(h.at(-1),t[0],e),l&&t.length>1&&t.some(d=>d.efforts?.drives.some(p=>p.arrow))&&h.at(-1).append(D("li",{className:"effort"},cg(),"torque or force of a drive, while it acts")),n.replaceChildren(c,nh(t,e),...h,th(t,l!==null,o)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} moving`);let u=eh(n,t,e,l?.eye,dr[0]);function f(){e.pause(),u(),l?.dispose(),n.replaceChildren()}return{stage:l,dispose:f}}function sh(n,t,e,{energy:i,legend:s,text:r,whole:o},a){let l=Ua(t,e,u=>yf(u,i.largest_J),r,a);if(!l)return n.replaceChildren(D("p",{className:"note"},rh(o))),{stage:l};let c=D("div",{className:"picture"},l.element,oh(l.eye,null,!a)),h=[_f(s,i,l.eye.size,null)];return t.some(u=>u.strained)&&h.unshift(hg(l,h[0])),n.replaceChildren(c,...h),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label",`the ${o} where the sliders are`),Jm(n,l.eye,dr[0]),{stage:l}}function Zw(n,t,e){let i=D("p",{className:"now","aria-hidden":"true"});n.append(i),e.onChange(()=>{i.textContent=ih(t,e.clipTime(0))})}function cg(){return D("span",{className:"swatch arrow","aria-hidden":"true"})}function Jw(n,t,e){let i=t.efforts.drives.some(r=>r.arrow),s=D("span");n.append(D("li",{className:"effort"},...i?[cg()]:[],s)),e.onChange(()=>{s.textContent=Om(t.efforts,e.clipTime(0),Te).join("; ")||"no drive acts now"})}function hg(n,t){let e=["panels","membrane strain"],i=D("li",{className:"energy",hidden:!0});t.append(i);let s=e.map((r,o)=>{let a=D("button",{type:"button","aria-pressed":String(!o)},r);return a.addEventListener("click",()=>{let l=n.showStrain(!!o);i.replaceChildren("membrane strain, Green’s: 0",xf(Zc),`${Te(100*l)} %`),i.hidden=!o;for(let c of t.querySelectorAll(".of-region"))c.hidden=!!o;for(let c of s)c.setAttribute("aria-pressed",String(c===a))}),a});return D("div",{className:"colours",role:"group","aria-label":"colour of the sheet"},"colour:",D("span",{},...s))}function rh(n){return`This browser has no WebGL, so the ${n} cannot be drawn in 3-D. The plots and all numbers are here.`}function oh(n,t,e=!0){let i=(c,h,u)=>{let f=D("button",{type:"button",title:h,"aria-label":h},c);return f.addEventListener("click",u),f},s=dr.map(c=>i(c.name,`${c.name}: view ${c.text}`,()=>n.show(c))),r=[["←","turn left",[-1,0]],["→","turn right",[1,0]],["↑","turn up",[0,1]],["↓","turn down",[0,-1]]].map(([c,h,u])=>i(c,h,()=>n.turn(...u))),o=(c,h,u)=>{let f=i(c,h,()=>{n.choose({[u]:!n.look[u]}),f.setAttribute("aria-pressed",String(n.look[u]))});return f.setAttribute("aria-pressed",String(n.look[u])),f},a=[...e?[o("follow","follow: keep the picture filled as it moves","following")]:[],...t?[o("one scale",`one scale: all ${t}s as large as they are by each other`,"oneScale")]:[]],l=[i("+","nearer",()=>n.zoom(1)),i("−","further",()=>n.zoom(-1))];return D("div",{className:"views",role:"group","aria-label":"view"},...a.length?[D("span",{},...a)]:[],D("span",{},...s),D("span",{className:"turns"},...r),D("span",{},...l))}var Kw={deg:.05};function go(n,t,e,i,s=0,r=!1){let{heading:o,names:a}=t.mesh.parts,l=t.readings.map(x=>({name:x.name,title:x.row,parts:x.parts,text:g=>bf(g,x.unit),ofState:g=>g.readings[x.name]&&jw(g.readings[x.name],x.unit)})),c=x=>Te(i.factor*x);t.tendons&&l.push({name:xs,title:`tendon energy (${i.unit})`,parts:t.mesh.tendonParts,text:c,ofState:x=>x.tendonEnergy_J.map(c)});let h=l.map(()=>a.map(()=>D("td"))),u=D("caption"),f=D("tr",{},o?D("th",{scope:"col"},o):D("td"),...a.map(x=>D("th",{scope:"col"},x))),d=l.map((x,g)=>D("tr",{},D("th",{scope:"row"},x.title),...h[g])),p=D("table",{className:"numbers"},u,D("thead",{},f),D("tbody",{},...d));return n.replaceChildren(D("div",{className:"table"},p)),n.classList.add("readout"),e.onChange(()=>{let x=e.clipTime(s),g=t.markAt(x),m=g?`, ${g.name} (means)`:"",_=r?`${t.name}: `:"",w=o?`every ${o}`:"everything";u.textContent=`${Rn(`${_}${w}`)} at ${pr(e.time,e.span)}${m}`;for(let[b,S]of l.entries()){let M=g&&S.ofState(g)||Array.from(t.valuesAt(S.name,x),S.text);for(let[y,T]of S.parts.entries())h[b][T].textContent=M[y]}})}function bf(n,t){return t==="deg"?Nn(n,1):Te(n)}function jw({mean:n,swing:t},e){return n.map((i,s)=>{let r=t[s]>(Kw[e]??.005*Math.abs(i));return`${bf(i,e)}${r?` ± ${bf(t[s],e)}`:""}`})}var Qw=0;function _o(n=document){let t=new ResizeObserver(e=>{for(let{target:i}of e)if(i.scrollWidth>i.clientWidth||i.scrollHeight>i.clientHeight)t1(i);else for(let s of["tabindex","role","aria-label","aria-labelledby"])i.removeAttribute(s)});for(let e of n.querySelectorAll(".table"))t.observe(e)}function t1(n){let{caption:t}=n.querySelector("table");if(n.tabIndex=0,n.setAttribute("role","group"),!t){let e=[...n.querySelectorAll("thead th")].map(i=>i.textContent);return n.setAttribute("aria-label",e.join(", ")||"table")}return t.id||=`caption-${++Qw}`,n.setAttribute("aria-labelledby",t.id)}function e1(n,t){let e=n.design.text.split(`
`);for(let{key:i,unit:s,factor:r,line:o}of n.knobs)i in t&&(e[o.number]=`${o.before}${n1(t[i],s,r)}${o.after}`);return e.join(`
`)}function n1(n,t,e){return`${Number((e*n).toPrecision(12))} ${t}`}function ug(n){let t=D("a",{className:"button",download:"design.toml"},"This setting as a design file"),e=D("code"),i=D("div",{className:"setting"},t,D("pre",{},e));function s(r){let o=new TextEncoder().encode(e1(n,r));t.href=`data:application/toml;base64,${btoa(String.fromCharCode(...o))}`,e.textContent="forficula run design.toml"}return s({}),{element:i,refresh:s}}var i1=22,s1=.25;function fg(n,t,e,i,s){let{canvas:r,eye:o}=n,a=document.createElementNS("http://www.w3.org/2000/svg","line"),l=document.createElementNS("http://www.w3.org/2000/svg","svg");l.classList.add("push"),l.setAttribute("aria-hidden","true"),l.append(a);let c=D("p",{className:"pushed","aria-hidden":"true"});n.element.append(l,c),l.style.display="none";let h=new W,u=null;function f(_){let w=h.fromArray(t.frame.points,3*_).project(o.camera);return[(w.x+1)/2*r.clientWidth,(1-w.y)/2*r.clientHeight]}function d(_){let w=r.getBoundingClientRect();return[_.clientX-w.left,_.clientY-w.top]}function p([_,w]){let b={point:-1,away:i1};for(let S=0;S<t.movable.length;S++){if(!t.movable[S])continue;let[M,y]=f(S),T=Math.hypot(M-_,y-w);T<b.away&&(b={point:S,away:T})}return b.point}function x(_){let[w,b]=d(_),S=new W().fromArray(t.frame.points,3*u),M=S.clone().project(o.camera).z;return new W(2*w/r.clientWidth-1,1-2*b/r.clientHeight,M).unproject(o.camera).sub(S).multiplyScalar(i/(s1*e)).clampLength(0,i).toArray()}function g(_,w){let[b,S]=[f(u),d(_)];for(let[M,y]of[["x1",b[0]],["y1",b[1]],["x2",S[0]],["y2",S[1]]])a.setAttribute(M,y);l.style.display="",c.textContent=`pushed with ${Te(w)} N`}r.addEventListener("pointerdown",_=>{let w=_.button===0?p(d(_)):-1;w<0||(u=w,o.controls.enabled=!1,r.setPointerCapture(_.pointerId),_.stopImmediatePropagation())},{capture:!0}),r.addEventListener("pointermove",_=>{if(u===null){r.classList.toggle("grip",p(d(_))>=0);return}let w=x(_);s(u,w),g(_,Math.hypot(...w))});let m=()=>{u!==null&&(u=null,o.controls.enabled=!0,l.style.display="none",c.textContent="",s(0,null))};r.addEventListener("pointerup",m),r.addEventListener("pointercancel",m)}var Oa=200,r1=20,o1=3;function dg(n,t,e){let i=n.map(o=>a1(o,t,e)),s=D("button",{type:"button",disabled:!0},`All as in ${t}`);s.addEventListener("click",()=>i.forEach(o=>o.reset()));let r=D("div",{className:"sliders",role:"group","aria-label":"what can be changed"});return r.append(...i.map(o=>o.element),s),{element:r,set(o){for(let a of i)a.put(o[a.knob.key]??a.knob.value)},get changes(){let o=i.filter(a=>a.value!==a.knob.value);return Object.fromEntries(o.map(a=>[a.knob.key,a.value]))},refresh(){s.disabled=i.every(o=>o.value===o.knob.value)}}}function a1(n,t,e){let{key:i,title:s,unit:r,factor:o,lowest:a,highest:l}=n,c=a>0&&l/a>=r1,h=S=>c?a*(l/a)**S:a+S*(l-a),u=S=>c?Math.log(S/a)/Math.log(l/a):(S-a)/(l-a),f=Math.round(Oa*u(n.value)),d=Rn(i.replace("protocol.","").replace("youngs","Young's").replaceAll(/[._]/g," ")),p=D("input",{type:"range",min:0,max:Oa,step:1,"aria-label":d,"aria-description":s}),x=D("output"),g=D("span",{className:"home",title:`in ${t}`,"aria-hidden":"true"});g.style.left=`${100*f/Oa}%`,p.dataset.keys="own";let m=n.value;function _(){let S=`${Te(o*m)} ${r}`;x.textContent=S,p.setAttribute("aria-valuetext",m===n.value?`${S}, as in ${t}`:S),b.classList.toggle("changed",m!==n.value)}function w(S){m=S,p.value=Math.round(Oa*u(m)),_(),e(i,m)}p.addEventListener("input",()=>{let S=Number(p.value);m=S===f?n.value:Number((o*h(S/Oa)).toPrecision(o1))/o,_(),e(i,m)});let b=D("label",{className:"slider",title:`${i}: ${s}`},D("span",{className:"name"},d),x,D("span",{className:"rail"},p,g));return p.value=f,_(),{element:b,knob:n,get value(){return m},put:w,reset:()=>w(n.value)}}var l1=[["real time",1],["1/2",.5],["1/5",.2],["1/20",.05],["1/100",.01]],pg=.2,c1=1.4,h1=[["J",1,.1],["mJ",1e3,1e-4],["µJ",1e6,1e-7],["nJ",1e9,0]];async function ah(n,t,e,i){let s=JSON.parse(e),r={frame:null,engine:null},o=await i(e,S=>w(S)),a=$m(n,s,o.first),l=D("p",{className:"verdict",role:"status"}),c=D("p",{className:"note"}),h=D("p",{className:"time"}),u=D("p",{className:"account"}),f=D("div"),d=D("div"),p=ug(s),x=dg(s.knobs,t.kind==="bench"?"the design":"this run",(S,M)=>{o.tell({act:"set",values:{[S]:M}}),x.refresh(),p.refresh(x.changes)}),g=f1(s,o,()=>{l.textContent="",c.textContent=""}),m=s.motors.every(S=>S.kind==="torque")?"torques":"drives",_=null;function w(S){if(S.said==="refused"){l.textContent=`The simulator stopped: ${S.why}.`;return}S.said==="frame"&&b(S.frame)}function b(S){r.frame=S,a.show(S),h.textContent=`${pr(S.time_s,{start:0,end:Math.max(1,S.time_s)})}${d1(S)}`;let M=S.energies_J.reduce((R,F)=>R+F,0),y=S.works_J.reduce((R,F)=>R+F,0),T=[...n.tendons?[`tendon energy ${Sf(M)}`]:[],`work of the ${m} ${Sf(y)}`];u.textContent=T.join(" · ");let I=S.stageNumber===null?S.ended:null,P=I&&JSON.stringify(I.stages.map(R=>R.end_s));P!==_&&(l.textContent=I?p1(I,t.whole):"",c.textContent=I?.advice??""),_=P}return r.element=D("div",{className:"trial"},D("div",{className:"seen"},D("div",{className:"choices"},...g),D("div",{className:"told"},h,u),l,c,f,d),D("div",{className:"hands"},x.element,p.element)),r.begin=()=>{let S={...Ia(),following:!1,closer:t.kind==="bench"?c1:1},{stage:M}=sh(f,[a.clip],a.clock,{...t,text:t.text.replace("which moves with the time","live")},S);r.stage=M,go(d,a.clip,a.clock,t.energy),_o(r.element),M&&(a.movable=s.anchors.bodies.map(y=>y>0),fg(M,a,n.mesh.span_m,u1(s,n.mesh.span_m),(y,T)=>o.tell({act:"push",point:y,force:T}))),b(o.first),o.tell({act:"pace",value:pg}),o.tell({act:"restart",through:!1}),t.kind!=="bench"&&g[0].focus()},Object.assign(r,{engine:o,live:a,sliders:x,design:p,own:s})}function u1({protocol:n,motors:t},e){let i=n.drives.map(({strength:s,torques:r})=>{let o=t[r.findIndex(a=>a!==0)];return o?.kind==="torque"?Math.abs(s)/e:o?.kind==="force"?Math.abs(s):0});return Math.max(...i)||1}function f1({protocol:n},t,e){let i=(o,a,l)=>{let c=D("button",{type:"button",title:l});return c.append(o),c.addEventListener("click",()=>{e(),t.tell(a)}),c},s=n.stages.flatMap(({name:o,drives:a},l)=>{if(!a.length)return[];let c=n.stages.findIndex((u,f)=>f>l&&u.drives.length>0),h=(c<0?n.stages.length:c)-1;return[i(Rn(o),{act:"stages",from:l,to:h},`the stage "${o}" of the protocol, and what follows without a drive`)]}),r=D("select",{},...l1.map(([o,a])=>D("option",{value:a,selected:a===pg},o)));return r.addEventListener("change",()=>t.tell({act:"pace",value:Number(r.value)})),[i("Start again",{act:"restart",through:!1},"from where the run begins"),...s,i("Let go",{act:"release"},"without any drive"),i("Whole protocol",{act:"restart",through:!0},"all stages, as in the run"),D("label",{},"speed ",r)]}function d1({stage:n,running:t}){return n?` · ${n}`:t?" · no drive acts":" · at rest"}function p1({status:n,verdict:t,transitions:e},i){let s=e.filter(({took:o})=>o?.succeeded&&o.time_s!==null).map(({words:o,took:a})=>`${o.did||o.done} in ${m1(a.time_s)} for ${Sf(a.work_J)} of work`);if(!s.length)return`${Rn(n)}.`;let r=t==="reached"?"":`; then: ${n}`;return`The ${i} ${s.join(", then ")}${r}.`}function m1(n){return n>=1?`${Nn(n,3)} s`:`${Te(1e3*n)} ms`}function Sf(n){let[t,e]=h1.find(([,,i])=>Math.abs(n)>=i);return n===0?"0 J":`${Te(e*n)} ${t}`}function lh(n,t,e,i){if(!n)return null;let s={panel:null,failed:"",start:null},r=document.getElementById("live").textContent,o=D("button",{type:"button",className:"try"},"Try it"),a=D("p",{className:"note"});a.textContent=`Move this ${e.whole} yourself: change it, drive it, let go, push it; the simulator runs in this page.`,n.append(D("div",{className:"offer"},o,a));function l(h){s.failed=h,o.disabled=!0,a.textContent=`This ${e.whole} cannot be moved here: ${h}. The command line can: forficula run.`}let c=JSON.parse(r.startsWith('{"refused"')?r:"null");return c!==null?l(c.refused):Jc()||l("this page was written without the engine"),s.start=async()=>{if(!o.disabled){o.disabled=!0,a.setAttribute("role","status"),a.textContent="Starting the simulator …",i();try{s.panel=await ah(t,e,r,Kc),n.replaceChildren(D("h2",{},"Try it"),s.panel.element),s.panel.begin()}catch(h){l(h.message)}}},o.addEventListener("click",s.start),s}function mg(n){let t=xi(n.clips[0]),e=lh(document.getElementById("try"),t,n,()=>{});return e.start(),{clips:[t],trial:e}}var g1=200;function ys(n,t){let e=new Set,i=t[0].start,s=t[0],r="even",o=!1,a=0,l=0,c=new Map;function h(){return c.has(s)||c.set(s,ag(n,s)),c.get(s)}let u=()=>r==="even"&&s.whole;function f(_){return u()?h().wayAt(_):(_-s.start)/(s.end-s.start||1)}function d(_){return u()?h().timeAt(_):s.start+_*(s.end-s.start)}function p(){l||(l=requestAnimationFrame(x))}function x(_){if(l=0,o){let w=Math.min((_-a)/1e3,.1);a=_,g(w),l=requestAnimationFrame(x)}for(let w of e)w()}function g(_){r==="even"?i=h().timeAt(Math.min(1,h().wayAt(i)+_/h().seconds)):i=Math.min(s.end,i+r*_),i>=s.end&&(o=!1)}function m(_){i=Math.min(s.end,Math.max(s.start,_)),p()}return{get time(){return i},get span(){return s},get speed(){return r},get playing(){return o},spans:t,clipTime:(_,w=i)=>Math.min(n[_].end,Math.max(n[_].start,w+s.origins[_])),get stretched(){return u()},shareAt:f,momentAt:d,wayAt:_=>h().wayAt(_),timeAt:_=>h().timeAt(_),get slowness(){if(r!=="even")return 1/r;let _=h().wayAt(i),[w,b]=[Math.max(0,_-5e-4),Math.min(1,_+5e-4)];return(b-w)*h().seconds/(h().timeAt(b)-h().timeAt(w)||1e-12)},onChange(_){return e.add(_),p(),()=>e.delete(_)},seek:m,seekClip(_,w){(w<s.start+s.origins[_]||w>s.end+s.origins[_])&&(s=t.find(b=>w>=b.start+b.origins[_]&&w<=b.end+b.origins[_])??t[0]),m(w-s.origins[_])},step:_=>m(d(f(i)+_/g1)),play(){i>=s.end&&(i=s.start),o=!0,a=performance.now(),p()},pause(){o=!1,p()},setSpeed(_){r=_,p()},setSpan(_){s=_,m(i<s.start||i>s.end?s.start:i)},redraw:p}}var _1="uplot",x1="u-hz",y1="u-vt",v1="u-title",b1="u-wrap",S1="u-under",M1="u-over",w1="u-axis",_r="u-off",A1="u-select",T1="u-cursor-x",E1="u-cursor-y",C1="u-cursor-pt",R1="u-legend",P1="u-live",I1="u-inline",L1="u-series",N1="u-marker",gg="u-label",D1="u-value",Ba="width",ka="height";var _g="bottom",xo="left",Mf="right",zf="#000",xg=zf+"0",wf="mousemove",yg="mousedown",Af="mouseup",vg="mouseenter",bg="mouseleave",Sg="dblclick",U1="resize",O1="scroll",Mg="change",dh="dppxchange",Vf="--",Ao=typeof window<"u",Pf=Ao?document:null,vo=Ao?window:null,F1=Ao?navigator:null,we,ch;function If(){let n=devicePixelRatio;we!=n&&(we=n,ch&&Nf(Mg,ch,If),ch=matchMedia(`(min-resolution: ${we-.001}dppx) and (max-resolution: ${we+.001}dppx)`),xr(Mg,ch,If),vo.dispatchEvent(new CustomEvent(dh)))}function hi(n,t){if(t!=null){let e=n.classList;!e.contains(t)&&e.add(t)}}function Lf(n,t){let e=n.classList;e.contains(t)&&e.remove(t)}function He(n,t,e){n.style[t]=e+"px"}function Ii(n,t,e,i){let s=Pf.createElement(n);return t!=null&&hi(s,t),e?.insertBefore(s,i),s}function yi(n,t){return Ii("div",n,t)}var wg=new WeakMap;function Ji(n,t,e,i,s){let r="translate("+t+"px,"+e+"px)",o=wg.get(n);r!=o&&(n.style.transform=r,wg.set(n,r),t<0||e<0||t>i||e>s?hi(n,_r):Lf(n,_r))}var Ag=new WeakMap;function Tg(n,t,e){let i=t+e,s=Ag.get(n);i!=s&&(Ag.set(n,i),n.style.background=t,n.style.borderColor=e)}var Eg=new WeakMap;function Cg(n,t,e,i){let s=t+""+e,r=Eg.get(n);s!=r&&(Eg.set(n,s),n.style.height=e+"px",n.style.width=t+"px",n.style.marginLeft=i?-t/2+"px":0,n.style.marginTop=i?-e/2+"px":0)}var Gf={passive:!0},B1={...Gf,capture:!0};function xr(n,t,e,i){t.addEventListener(n,e,i?B1:Gf)}function Nf(n,t,e,i){t.removeEventListener(n,e,Gf)}Ao&&If();function Li(n,t,e,i){let s;e=e||0,i=i||t.length-1;let r=i<=2147483647;for(;i-e>1;)s=r?e+i>>1:ui((e+i)/2),t[s]<n?e=s:i=s;return n-t[e]<=t[i]-n?e:i}function n0(n){return(e,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(e[a])){r=a;break}for(let a=s;a>=i;a--)if(n(e[a])){o=a;break}return[r,o]}}var i0=n=>n!=null,s0=n=>n!=null&&n>0,gh=n0(i0),k1=n0(s0);function z1(n,t,e,i=0,s=!1){let r=s?k1:gh,o=s?s0:i0;[t,e]=r(n,t,e);let a=n[t],l=n[t];if(t>-1)if(i==1)a=n[t],l=n[e];else if(i==-1)a=n[e],l=n[t];else for(let c=t;c<=e;c++){let h=n[c];o(h)&&(h<a?a=h:h>l&&(l=h))}return[a??De,l??-De]}function _h(n,t,e,i){let s=Ig(n),r=Ig(t);n==t&&(s==-1?(n*=e,t/=e):(n/=e,t*=e));let o=e==10?vs:r0,a=s==1?ui:vi,l=r==1?vi:ui,c=a(o(bn(n))),h=l(o(bn(t))),u=bo(e,c),f=bo(e,h);return e==10&&(c<0&&(u=Ue(u,-c)),h<0&&(f=Ue(f,-h))),i||e==2?(n=u*s,t=f*r):(n=c0(n,u),t=xh(t,f)),[n,t]}function Hf(n,t,e,i){let s=_h(n,t,e,i);return n==0&&(s[0]=0),t==0&&(s[1]=0),s}var Wf=.1,Rg={mode:3,pad:Wf},Va={pad:0,soft:null,mode:0},V1={min:Va,max:Va};function ph(n,t,e,i){return yh(e)?Pg(n,t,e):(Va.pad=e,Va.soft=i?0:null,Va.mode=i?3:0,Pg(n,t,V1))}function be(n,t){return n??t}function G1(n,t,e){for(t=be(t,0),e=be(e,n.length-1);t<=e;){if(n[t]!=null)return!0;t++}return!1}function Pg(n,t,e){let i=e.min,s=e.max,r=be(i.pad,0),o=be(s.pad,0),a=be(i.hard,-De),l=be(s.hard,De),c=be(i.soft,De),h=be(s.soft,-De),u=be(i.mode,0),f=be(s.mode,0),d=t-n,p=vs(d),x=Yn(bn(n),bn(t)),g=vs(x),m=bn(g-p);(d<1e-24||m>10)&&(d=0,(n==0||t==0)&&(d=1e-24,u==2&&c!=De&&(r=0),f==2&&h!=-De&&(o=0)));let _=d||x||1e3,w=vs(_),b=bo(10,ui(w)),S=_*(d==0?n==0?.1:1:r),M=Ue(c0(n-S,b/10),24),y=n>=c&&(u==1||u==3&&M<=c||u==2&&M>=c)?c:De,T=Yn(a,M<y&&n>=y?y:Ni(y,M)),I=_*(d==0?t==0?.1:1:o),P=Ue(xh(t+I,b/10),24),R=t<=h&&(f==1||f==3&&P>=h||f==2&&P<=h)?h:-De,F=Ni(l,P>R&&t<=R?R:Yn(R,P));return T==F&&T==0&&(F=100),[T,F]}var H1=new Intl.NumberFormat(Ao?F1.language:"en-US"),Xf=n=>H1.format(n),fi=Math,fh=fi.PI,bn=fi.abs,ui=fi.floor,vn=fi.round,vi=fi.ceil,Ni=fi.min,Yn=fi.max,bo=fi.pow,Ig=fi.sign,vs=fi.log10,r0=fi.log2,W1=(n,t=1)=>fi.sinh(n)*t,Tf=(n,t=1)=>fi.asinh(n/t),De=1/0;function Lg(n){return(vs((n^n>>31)-(n>>31))|0)+1}function Df(n,t,e){return Ni(Yn(n,t),e)}function o0(n){return typeof n=="function"}function xe(n){return o0(n)?n:()=>n}var X1=()=>{},a0=n=>n,l0=(n,t)=>t,q1=n=>null,Ng=n=>!0,Dg=(n,t)=>n==t,$1=/\.\d*?(?=9{6,}|0{6,})/gm,yr=n=>{if(u0(n)||Zs.has(n))return n;let t=`${n}`,e=t.match($1);if(e==null)return n;let i=e[0].length-1;if(t.indexOf("e-")!=-1){let[s,r]=t.split("e");return+`${yr(s)}e${r}`}return Ue(n,i)};function mr(n,t){return yr(Ue(yr(n/t))*t)}function xh(n,t){return yr(vi(yr(n/t))*t)}function c0(n,t){return yr(ui(yr(n/t))*t)}function Ue(n,t=0){if(u0(n))return n;let e=10**t,i=n*e*(1+Number.EPSILON);return vn(i)/e}var Zs=new Map;function h0(n){return((""+n).split(".")[1]||"").length}function Ha(n,t,e,i){let s=[],r=i.map(h0);for(let o=t;o<e;o++){let a=bn(o),l=Ue(bo(n,o),a);for(let c=0;c<i.length;c++){let h=n==10?+`${i[c]}e${o}`:i[c]*l,u=(o>=0?0:a)+(o>=r[c]?0:r[c]),f=n==10?h:Ue(h,u);s.push(f),Zs.set(f,u)}}return s}var Ga={},qf=[],So=[null,null],Ys=Array.isArray,u0=Number.isInteger,Y1=n=>n===void 0;function Ug(n){return typeof n=="string"}function yh(n){let t=!1;if(n!=null){let e=n.constructor;t=e==null||e==Object}return t}function Z1(n){return n!=null&&typeof n=="object"}var J1=Object.getPrototypeOf(Uint8Array),f0="__proto__";function Mo(n,t=yh){let e;if(Ys(n)){let i=n.find(s=>s!=null);if(Ys(i)||t(i)){e=Array(n.length);for(let s=0;s<n.length;s++)e[s]=Mo(n[s],t)}else e=n.slice()}else if(n instanceof J1)e=n.slice();else if(t(n)){e={};for(let i in n)i!=f0&&(e[i]=Mo(n[i],t))}else e=n;return e}function dn(n){let t=arguments;for(let e=1;e<t.length;e++){let i=t[e];for(let s in i)s!=f0&&(yh(n[s])?dn(n[s],Mo(i[s])):n[s]=Mo(i[s]))}return n}var K1=0,j1=1,Q1=2;function tA(n,t,e){for(let i=0,s,r=-1;i<t.length;i++){let o=t[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<e&&n[s]==null;)n[r=s++]=null}}}function eA(n,t){if(sA(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return rA(o[0])||(o=iA(o)),o}let e=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let h=0;h<c;h++)e.add(l[h])}let i=[Array.from(e).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let h=a[c],u=Array(s).fill(void 0),f=t?t[o][c]:j1,d=[];for(let p=0;p<h.length;p++){let x=h[p],g=r.get(l[p]);x===null?f!=K1&&(u[g]=x,f==Q1&&d.push(g)):u[g]=x}tA(u,d,s),i.push(u)}}return i}var nA=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function iA(n){let t=n[0],e=t.length,i=Array(e);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>t[r]-t[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(e);for(let l=0;l<e;l++)a[l]=o[i[l]];s.push(a)}return s}function sA(n){let t=n[0][0],e=t.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=e)return!1;if(s!=t){for(let r=0;r<e;r++)if(s[r]!=t[r])return!1}}return!0}function rA(n,t=100){let e=n.length;if(e<=1)return!0;let i=0,s=e-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=Yn(1,ui((s-i+1)/t));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var d0=["January","February","March","April","May","June","July","August","September","October","November","December"],p0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function m0(n){return n.slice(0,3)}var oA=p0.map(m0),aA=d0.map(m0),lA={MMMM:d0,MMM:aA,WWWW:p0,WWW:oA};function Fa(n){return(n<10?"0":"")+n}function cA(n){return(n<10?"00":n<100?"0":"")+n}var hA={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,t)=>t.MMMM[n.getMonth()],MMM:(n,t)=>t.MMM[n.getMonth()],MM:n=>Fa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Fa(n.getDate()),D:n=>n.getDate(),WWWW:(n,t)=>t.WWWW[n.getDay()],WWW:(n,t)=>t.WWW[n.getDay()],HH:n=>Fa(n.getHours()),H:n=>n.getHours(),h:n=>{let t=n.getHours();return t==0?12:t>12?t-12:t},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Fa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Fa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>cA(n.getMilliseconds())};function $f(n,t){t=t||lA;let e=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)e.push(s[0][0]=="{"?hA[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<e.length;a++)o+=typeof e[a]=="string"?e[a]:e[a](r,t);return o}}var uA=new Intl.DateTimeFormat().resolvedOptions().timeZone;function fA(n,t){let e;return t=="UTC"||t=="Etc/UTC"?e=new Date(+n+n.getTimezoneOffset()*6e4):t==uA?e=n:(e=new Date(n.toLocaleString("en-US",{timeZone:t})),e.setMilliseconds(n.getMilliseconds())),e}var g0=n=>n%1==0,mh=[1,2,2.5,5],dA=Ha(10,-32,0,mh),_0=Ha(10,0,32,mh),pA=_0.filter(g0),gr=dA.concat(_0),Yf=`
`,x0="{YYYY}",Og=Yf+x0,y0="{M}/{D}",za=Yf+y0,hh=za+"/{YY}",v0="{aa}",mA="{h}:{mm}",yo=mA+v0,Fg=Yf+yo,Bg=":{ss}",Ee=null;function b0(n){let t=n*1e3,e=t*60,i=e*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ha(10,0,3,mh).filter(g0):Ha(10,-3,0,mh)).concat([t,t*5,t*10,t*15,t*30,e,e*5,e*10,e*15,e*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,x0,Ee,Ee,Ee,Ee,Ee,Ee,1],[s*28,"{MMM}",Og,Ee,Ee,Ee,Ee,Ee,1],[s,y0,Og,Ee,Ee,Ee,Ee,Ee,1],[i,"{h}"+v0,hh,Ee,za,Ee,Ee,Ee,1],[e,yo,hh,Ee,za,Ee,Ee,Ee,1],[t,Bg,hh+" "+yo,Ee,za+" "+yo,Ee,Fg,Ee,1],[n,Bg+".{fff}",hh+" "+yo,Ee,za+" "+yo,Ee,Fg,Ee,1]];function h(u){return(f,d,p,x,g,m)=>{let _=[],w=g>=o,b=g>=r&&g<o,S=u(p),M=Ue(S*n,3),y=Ef(S.getFullYear(),w?0:S.getMonth(),b||w?1:S.getDate()),T=Ue(y*n,3);if(b||w){let I=b?g/r:0,P=w?g/o:0,R=M==T?M:Ue(Ef(y.getFullYear()+P,y.getMonth()+I,1)*n,3),F=new Date(vn(R/n)),z=F.getFullYear(),U=F.getMonth();for(let G=0;R<=x;G++){let q=Ef(z+P*G,U+I*G,1),H=q-u(Ue(q*n,3));R=Ue((+q+H)*n,3),R<=x&&_.push(R)}}else{let I=g>=s?s:g,P=ui(p)-ui(M),R=T+P+xh(M-T,I);_.push(R);let F=u(R),z=F.getHours()+F.getMinutes()/e+F.getSeconds()/i,U=g/i,G=f.axes[d]._space,q=m/G;for(;R=Ue(R+g,n==1?0:3),!(R>x);)if(U>1){let H=ui(Ue(z+U,6))%24,Q=u(R).getHours()-H;Q>1&&(Q=-1),R-=Q*i,z=(z+U)%24;let it=_[_.length-1];Ue((R-it)/g,3)*q>=.7&&_.push(R)}else _.push(R)}return _}}return[l,c,h]}var[gA,_A,xA]=b0(1),[yA,vA,bA]=b0(.001);Ha(2,-53,53,[1]);function kg(n,t){return n.map(e=>e.map((i,s)=>s==0||s==8||i==null?i:t(s==1||e[8]==0?i:e[1]+i)))}function zg(n,t){return(e,i,s,r,o)=>{let a=t.find(p=>o>=p[0])||t[t.length-1],l,c,h,u,f,d;return i.map(p=>{let x=n(p),g=x.getFullYear(),m=x.getMonth(),_=x.getDate(),w=x.getHours(),b=x.getMinutes(),S=x.getSeconds(),M=g!=l&&a[2]||m!=c&&a[3]||_!=h&&a[4]||w!=u&&a[5]||b!=f&&a[6]||S!=d&&a[7]||a[1];return l=g,c=m,h=_,u=w,f=b,d=S,M(x)})}}function SA(n,t){let e=$f(t);return(i,s,r,o,a)=>s.map(l=>e(n(l)))}function Ef(n,t,e){return new Date(n,t,e)}function Vg(n,t){return t(n)}var MA="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function Gg(n,t){return(e,i,s,r)=>r==null?Vf:t(n(i))}function wA(n,t){let e=n.series[t];return e.width?e.stroke(n,t):e.points.width?e.points.stroke(n,t):null}function AA(n,t){return n.series[t].fill(n,t)}var TA={show:!0,live:!0,isolate:!1,mount:X1,markers:{show:!0,width:2,stroke:wA,fill:AA,dash:"solid"},idx:null,idxs:null,values:[]};function EA(n,t){let e=n.cursor.points,i=yi(),s=e.size(n,t);He(i,Ba,s),He(i,ka,s);let r=s/-2;He(i,"marginLeft",r),He(i,"marginTop",r);let o=e.width(n,t,s);return o&&He(i,"borderWidth",o),i}function CA(n,t){let e=n.series[t].points;return e._fill||e._stroke}function RA(n,t){let e=n.series[t].points;return e._stroke||e._fill}function PA(n,t){return n.series[t].points.size}var Cf=[0,0];function IA(n,t,e){return Cf[0]=t,Cf[1]=e,Cf}function uh(n,t,e,i=!0){return s=>{s.button==0&&(!i||s.target==t)&&e(s)}}function Rf(n,t,e,i=!0){return s=>{(!i||s.target==t)&&e(s)}}var LA={show:!0,x:!0,y:!0,lock:!1,move:IA,points:{one:!1,show:EA,size:PA,width:0,stroke:RA,fill:CA},bind:{mousedown:uh,mouseup:uh,click:uh,dblclick:uh,mousemove:Rf,mouseleave:Rf,mouseenter:Rf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,t)=>{t.stopPropagation(),t.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,t,e,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},S0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Zf=dn({},S0,{filter:l0}),M0=dn({},Zf,{size:10}),w0=dn({},S0,{show:!1}),Jf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',A0="bold "+Jf,T0=1.5,Hg={show:!0,scale:"x",stroke:zf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:A0,side:2,grid:Zf,ticks:M0,border:w0,font:Jf,lineGap:T0,rotate:0},NA="Value",DA="Time",Wg={show:!0,scale:"x",auto:!1,sorted:1,min:De,max:-De,idxs:[]};function UA(n,t,e,i,s){return t.map(r=>r==null?"":Xf(r))}function OA(n,t,e,i,s,r,o){let a=[],l=Zs.get(s)||0;e=o?e:Ue(xh(e,s),l);for(let c=e;c<=i;c=Ue(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Uf(n,t,e,i,s,r,o){let a=[],l=n.scales[n.axes[t].scale].log,c=l==10?vs:r0,h=ui(c(e));s=bo(l,h),l==10&&(s=gr[Li(s,gr)]);let u=e,f=s*l;l==10&&(f=gr[Li(f,gr)]);do a.push(u),u=u+s,l==10&&!Zs.has(u)&&(u=Ue(u,Zs.get(s))),u>=f&&(s=u,f=s*l,l==10&&(f=gr[Li(f,gr)]));while(u<=i);return a}function FA(n,t,e,i,s,r,o){let l=n.scales[n.axes[t].scale].asinh,c=i>l?Uf(n,t,Yn(l,e),i,s):[l],h=i>=0&&e<=0?[0]:[];return(e<-l?Uf(n,t,Yn(l,-i),-e,s):[l]).reverse().map(f=>-f).concat(h,c)}var E0=/./,BA=/[12357]/,kA=/[125]/,Xg=/1/,Of=(n,t,e,i)=>n.map((s,r)=>t==4&&s==0||r%i==0&&e.test(s.toExponential()[s<0?1:0])?s:null);function zA(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,h=l(10,o),u=l(9,o)-h>=c?E0:l(7,o)-h>=c?BA:l(5,o)-h>=c?kA:Xg;if(u==Xg){let f=bn(l(1,o)-h);if(f<c)return Of(t.slice().reverse(),a.distr,u,vi(c/f)).reverse()}return Of(t,a.distr,u,1)}function VA(n,t,e,i,s){let r=n.axes[e],o=r.scale,a=r._space,l=n.valToPos,c=bn(l(1,o)-l(2,o));return c<a?Of(t.slice().reverse(),3,E0,vi(a/c)).reverse():t}function GA(n,t,e,i){return i==null?Vf:t==null?"":Xf(t)}var qg={show:!0,scale:"y",stroke:zf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:A0,side:3,grid:Zf,ticks:M0,border:w0,font:Jf,lineGap:T0,rotate:0};function HA(n,t){let e=3+(n||1)*2;return Ue(e*t,3)}function WA(n,t){let{scale:e,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],e,!0),o=n.valToPos(s[i[1]],e,!0),a=bn(o-r),l=n.series[t],c=a/(l.points.space*we);return i[1]-i[0]<=c}var $g={scale:null,auto:!0,sorted:0,min:De,max:-De},C0=(n,t,e,i,s)=>s,Yg={show:!0,auto:!0,sorted:0,gaps:C0,alpha:1,facets:[dn({},$g,{scale:"x"}),dn({},$g,{scale:"y"})]},Zg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:C0,alpha:1,points:{show:WA,filter:null},values:null,min:De,max:-De,idxs:[],path:null,clip:null};function XA(n,t,e,i,s){return e/10}var R0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},qA=dn({},R0,{time:!1,ori:1}),Jg={};function P0(n,t){let e=Jg[n];return e||(e={key:n,plots:[],sub(i){e.plots.push(i)},unsub(i){e.plots=e.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let h=0;h<e.plots.length;h++)e.plots[h]!=s&&e.plots[h].pub(i,s,r,o,a,l,c)}},n!=null&&(Jg[n]=e)),e}var wo=1,Ff=2;function vr(n,t,e){let i=n.mode,s=n.series[t],r=i==2?n._data[t]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[t],h=i==2?o[s.facets[0].scale]:o[n.series[0].scale],u=i==2?o[s.facets[1].scale]:o[s.scale],f=a.left,d=a.top,p=a.width,x=a.height,g=n.valToPosH,m=n.valToPosV;return h.ori==0?e(s,l,c,h,u,g,m,f,d,p,x,bh,To,Mh,L0,D0):e(s,l,c,h,u,m,g,d,f,x,p,Sh,Eo,Qf,N0,U0)}function Kf(n,t){let e=0,i=0,s=be(n.bands,qf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==t?e=o.dir:o.series[1]==t&&(o.dir==1?i|=1:i|=2)}return[e,i==1?-1:i==2?1:i==3?2:0]}function $A(n,t,e,i,s){let r=n.mode,o=n.series[t],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function bs(n,t,e,i,s,r){return vr(n,t,(o,a,l,c,h,u,f,d,p,x,g)=>{let m=o.pxRound,_=c.dir*(c.ori==0?1:-1),w=c.ori==0?To:Eo,b,S;_==1?(b=e,S=i):(b=i,S=e);let M=m(u(a[b],c,x,d)),y=m(f(l[b],h,g,p)),T=m(u(a[S],c,x,d)),I=m(f(r==1?h.max:h.min,h,g,p)),P=new Path2D(s);return w(P,T,I),w(P,M,I),w(P,M,y),P})}function vh(n,t,e,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=t==0?Mh:Qf,l=e;for(let u=0;u<n.length;u++){let f=n[u];if(f[1]>f[0]){let d=f[0]-l;d>0&&a(o,l,i,d,i+r),l=f[1]}}let c=e+s-l,h=10;c>0&&a(o,l,i-h/2,c,i+r+h)}return o}function YA(n,t,e){let i=n[n.length-1];i&&i[0]==t?i[1]=e:n.push([t,e])}function jf(n,t,e,i,s,r,o){let a=[],l=n.length;for(let c=s==1?e:i;c>=e&&c<=i;c+=s)if(t[c]===null){let u=c,f=c;if(s==1)for(;++c<=i&&t[c]===null;)f=c;else for(;--c>=e&&t[c]===null;)f=c;let d=r(n[u]),p=f==u?d:r(n[f]),x=u-s;d=o<=0&&x>=0&&x<l?r(n[x]):d;let m=f+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function Kg(n){return n==0?a0:n==1?vn:t=>mr(t,n)}function I0(n){let t=n==0?bh:Sh,e=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,h=0)=>{c==0&&h==0?i(s,r,o,a,l):(c=Ni(c,a/2,l/2),h=Ni(h,a/2,l/2),t(s,r+c,o),e(s,r+a,o,r+a,o+l,c),e(s,r+a,o+l,r,o+l,h),e(s,r,o+l,r,o,h),e(s,r,o,r+a,o,c),s.closePath())}}var bh=(n,t,e)=>{n.moveTo(t,e)},Sh=(n,t,e)=>{n.moveTo(e,t)},To=(n,t,e)=>{n.lineTo(t,e)},Eo=(n,t,e)=>{n.lineTo(e,t)},Mh=I0(0),Qf=I0(1),L0=(n,t,e,i,s,r)=>{n.arc(t,e,i,s,r)},N0=(n,t,e,i,s,r)=>{n.arc(e,t,i,s,r)},D0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(t,e,i,s,r,o)},U0=(n,t,e,i,s,r,o)=>{n.bezierCurveTo(e,t,s,i,o,r)};function O0(n){return(t,e,i,s,r)=>vr(t,e,(o,a,l,c,h,u,f,d,p,x,g)=>{let{pxRound:m,points:_}=o,w,b;c.ori==0?(w=bh,b=L0):(w=Sh,b=N0);let S=Ue(_.width*we,3),M=(_.size-_.width)/2*we,y=Ue(M*2,3),T=new Path2D,I=new Path2D,{left:P,top:R,width:F,height:z}=t.bbox;Mh(I,P-y,R-y,F+y*2,z+y*2);let U=G=>{if(l[G]!=null){let q=m(u(a[G],c,x,d)),H=m(f(l[G],h,g,p));w(T,q+M,H),b(T,q,H,M,0,fh*2)}};if(r)r.forEach(U);else for(let G=i;G<=s;G++)U(G);return{stroke:S>0?T:null,fill:T,clip:I,flags:wo|Ff}})}function F0(n){return(t,e,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(t,e,i),r!=s&&o!=s&&n(t,e,s),n(t,e,o))}}var ZA=F0(To),JA=F0(Eo);function B0(n){let t=be(n?.alignGaps,0);return(e,i,s,r)=>vr(e,i,(o,a,l,c,h,u,f,d,p,x,g)=>{[s,r]=gh(l,s,r);let m=o.pxRound,_=z=>m(u(z,c,x,d)),w=z=>m(f(z,h,g,p)),b,S;c.ori==0?(b=To,S=ZA):(b=Eo,S=JA);let M=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wo},T=y.stroke,I=!1;if(r-s>=x*4){let z=ft=>e.posToVal(ft,c.key,!0),U=null,G=null,q,H,lt,J=_(a[M==1?s:r]),Q=_(a[s]),it=_(a[r]),dt=z(M==1?Q+1:it-1);for(let ft=M==1?s:r;ft>=s&&ft<=r;ft+=M){let tt=a[ft],gt=(M==1?tt<dt:tt>dt)?J:_(tt),St=l[ft];gt==J?St!=null?(H=St,U==null?(b(T,gt,w(H)),q=U=G=H):H<U?U=H:H>G&&(G=H)):St===null&&(I=!0):(U!=null&&S(T,J,w(U),w(G),w(q),w(H)),St!=null?(H=St,b(T,gt,w(H)),U=G=q=H):(U=G=null,St===null&&(I=!0)),J=gt,dt=z(J+M))}U!=null&&U!=G&&lt!=J&&S(T,J,w(U),w(G),w(q),w(H))}else for(let z=M==1?s:r;z>=s&&z<=r;z+=M){let U=l[z];U===null?I=!0:U!=null&&b(T,_(a[z]),w(U))}let[R,F]=Kf(e,i);if(o.fill!=null||R!=0){let z=y.fill=new Path2D(T),U=o.fillTo(e,i,o.min,o.max,R),G=w(U),q=_(a[s]),H=_(a[r]);M==-1&&([H,q]=[q,H]),b(z,H,G),b(z,q,G)}if(!o.spanGaps){let z=[];I&&z.push(...jf(a,l,s,r,M,_,t)),y.gaps=z=o.gaps(e,i,s,r,z),y.clip=vh(z,c.ori,d,p,x,g)}return F!=0&&(y.band=F==2?[bs(e,i,s,r,T,-1),bs(e,i,s,r,T,1)]:bs(e,i,s,r,T,F)),y})}function KA(n){let t=be(n.align,1),e=be(n.ascDesc,!1),i=be(n.alignGaps,0),s=be(n.extend,!1);return(r,o,a,l)=>vr(r,o,(c,h,u,f,d,p,x,g,m,_,w)=>{[a,l]=gh(u,a,l);let b=c.pxRound,{left:S,width:M}=r.bbox,y=Q=>b(p(Q,f,_,g)),T=Q=>b(x(Q,d,w,m)),I=f.ori==0?To:Eo,P={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:wo},R=P.stroke,F=f.dir*(f.ori==0?1:-1),z=T(u[F==1?a:l]),U=y(h[F==1?a:l]),G=U,q=U;s&&t==-1&&(q=S,I(R,q,z)),I(R,U,z);for(let Q=F==1?a:l;Q>=a&&Q<=l;Q+=F){let it=u[Q];if(it==null)continue;let dt=y(h[Q]),ft=T(it);t==1?I(R,dt,z):I(R,G,ft),I(R,dt,ft),z=ft,G=dt}let H=G;s&&t==1&&(H=S+M,I(R,H,z));let[lt,J]=Kf(r,o);if(c.fill!=null||lt!=0){let Q=P.fill=new Path2D(R),it=c.fillTo(r,o,c.min,c.max,lt),dt=T(it);I(Q,H,dt),I(Q,q,dt)}if(!c.spanGaps){let Q=[];Q.push(...jf(h,u,a,l,F,y,i));let it=c.width*we/2,dt=e||t==1?it:-it,ft=e||t==-1?-it:it;Q.forEach(tt=>{tt[0]+=dt,tt[1]+=ft}),P.gaps=Q=c.gaps(r,o,a,l,Q),P.clip=vh(Q,f.ori,g,m,_,w)}return J!=0&&(P.band=J==2?[bs(r,o,a,l,R,-1),bs(r,o,a,l,R,1)]:bs(r,o,a,l,R,J)),P})}function jg(n,t,e,i,s,r,o=De){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(t[l]!==void 0){if(a!=null){let h=bn(n[l]-n[a]);h<c&&(c=h,o=bn(e(n[l],i,s,r)-e(n[a],i,s,r)))}a=l}}return o}function jA(n){n=n||Ga;let t=be(n.size,[.6,De,1]),e=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=xe(s),o=1-t[0],a=be(t[1],De),l=be(t[2],1),c=be(n.disp,Ga),h=be(n.each,d=>{}),{fill:u,stroke:f}=c;return(d,p,x,g)=>vr(d,p,(m,_,w,b,S,M,y,T,I,P,R)=>{let F=m.pxRound,z=e,U=i*we,G=a*we,q=l*we,H,lt;b.ori==0?[H,lt]=r(d,p):[lt,H]=r(d,p);let J=b.dir*(b.ori==0?1:-1),Q=b.ori==0?Mh:Qf,it=b.ori==0?h:(Rt,$t,re,wt,Ne,zt,Xt)=>{h(Rt,$t,re,Ne,wt,Xt,zt)},dt=be(d.bands,qf).find(Rt=>Rt.series[0]==p),ft=dt!=null?dt.dir:0,tt=m.fillTo(d,p,m.min,m.max,ft),ut=F(y(tt,S,R,I)),gt,St,Mt,Ht=P,se=F(m.width*we),Vt=!1,he=null,ae=null,ne=null,We=null;u!=null&&(se==0||f!=null)&&(Vt=!0,he=u.values(d,p,x,g),ae=new Map,new Set(he).forEach(Rt=>{Rt!=null&&ae.set(Rt,new Path2D)}),se>0&&(ne=f.values(d,p,x,g),We=new Map,new Set(ne).forEach(Rt=>{Rt!=null&&We.set(Rt,new Path2D)})));let{x0:Oe,size:on}=c;if(Oe!=null&&on!=null){z=1,_=Oe.values(d,p,x,g),Oe.unit==2&&(_=_.map(re=>d.posToVal(T+re*P,b.key,!0)));let Rt=on.values(d,p,x,g);on.unit==2?St=Rt[0]*P:St=M(Rt[0],b,P,T)-M(0,b,P,T),Ht=jg(_,w,M,b,P,T,Ht),Mt=Ht-St+U}else Ht=jg(_,w,M,b,P,T,Ht),Mt=Ht*o+U,St=Ht-Mt;Mt<1&&(Mt=0),se>=St/2&&(se=0),Mt<5&&(F=a0);let Ie=Mt>0,Sn=Ht-Mt-(Ie?se:0);St=F(Df(Sn,q,G)),gt=(z==0?St/2:z==J?0:St)-z*J*((z==0?U/2:0)+(Ie?se/2:0));let ye={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},pn=Vt?null:new Path2D,Ye=null;if(dt!=null)Ye=d.data[dt.series[1]];else{let{y0:Rt,y1:$t}=c;Rt!=null&&$t!=null&&(w=$t.values(d,p,x,g),Ye=Rt.values(d,p,x,g))}let an=H*St,k=lt*St;for(let Rt=J==1?x:g;Rt>=x&&Rt<=g;Rt+=J){let $t=w[Rt];if($t==null)continue;if(Ye!=null){let $=Ye[Rt]??0;if($t-$==0)continue;ut=y($,S,R,I)}let re=b.distr!=2||c!=null?_[Rt]:Rt,wt=M(re,b,P,T),Ne=y(be($t,tt),S,R,I),zt=F(wt-gt),Xt=F(Yn(Ne,ut)),L=F(Ni(Ne,ut)),A=Xt-L;if($t!=null){let $=$t<0?k:an,ht=$t<0?an:k;Vt?(se>0&&ne[Rt]!=null&&Q(We.get(ne[Rt]),zt,L+ui(se/2),St,Yn(0,A-se),$,ht),he[Rt]!=null&&Q(ae.get(he[Rt]),zt,L+ui(se/2),St,Yn(0,A-se),$,ht)):Q(pn,zt,L+ui(se/2),St,Yn(0,A-se),$,ht),it(d,p,Rt,zt-se/2,L,St+se,A)}}return se>0?ye.stroke=Vt?We:pn:Vt||(ye._fill=m.width==0?m._fill:m._stroke??m._fill,ye.width=0),ye.fill=Vt?ae:pn,ye})}function QA(n,t){let e=be(t?.alignGaps,0);return(i,s,r,o)=>vr(i,s,(a,l,c,h,u,f,d,p,x,g,m)=>{[r,o]=gh(c,r,o);let _=a.pxRound,w=H=>_(f(H,h,g,p)),b=H=>_(d(H,u,m,x)),S,M,y;h.ori==0?(S=bh,y=To,M=D0):(S=Sh,y=Eo,M=U0);let T=h.dir*(h.ori==0?1:-1),I=w(l[T==1?r:o]),P=I,R=[],F=[];for(let H=T==1?r:o;H>=r&&H<=o;H+=T)if(c[H]!=null){let J=l[H],Q=w(J);R.push(P=Q),F.push(b(c[H]))}let z={stroke:n(R,F,S,y,M,_),fill:null,clip:null,band:null,gaps:null,flags:wo},U=z.stroke,[G,q]=Kf(i,s);if(a.fill!=null||G!=0){let H=z.fill=new Path2D(U),lt=a.fillTo(i,s,a.min,a.max,G),J=b(lt);y(H,P,J),y(H,I,J)}if(!a.spanGaps){let H=[];H.push(...jf(l,c,r,o,T,w,e)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=vh(H,h.ori,p,x,g,m)}return q!=0&&(z.band=q==2?[bs(i,s,r,o,U,-1),bs(i,s,r,o,U,1)]:bs(i,s,r,o,U,q)),z})}function tT(n){return QA(eT,n)}function eT(n,t,e,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(e(a,n[0],t[0]),o==2)i(a,n[1],t[1]);else{let l=Array(o),c=Array(o-1),h=Array(o-1),u=Array(o-1);for(let f=0;f<o-1;f++)h[f]=t[f+1]-t[f],u[f]=n[f+1]-n[f],c[f]=h[f]/u[f];l[0]=c[0];for(let f=1;f<o-1;f++)c[f]===0||c[f-1]===0||c[f-1]>0!=c[f]>0?l[f]=0:(l[f]=3*(u[f-1]+u[f])/((2*u[f]+u[f-1])/c[f-1]+(u[f]+2*u[f-1])/c[f]),isFinite(l[f])||(l[f]=0));l[o-1]=c[o-2];for(let f=0;f<o-1;f++)s(a,n[f]+u[f]/3,t[f]+l[f]*u[f]/3,n[f+1]-u[f]/3,t[f+1]-l[f+1]*u[f]/3,n[f+1],t[f+1])}return a}var Bf=new Set;function Qg(){for(let n of Bf)n.syncRect(!0)}Ao&&(xr(U1,vo,Qg),xr(O1,vo,Qg,!0),xr(dh,vo,()=>{rn.pxRatio=we}));var nT=B0(),iT=O0();function t0(n,t,e,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>kf(r,o,t,e))}function sT(n,t){return n.map((e,i)=>i==0?{}:dn({},t,e))}function kf(n,t,e,i){return dn({},t==0?e:i,n)}function k0(n,t,e){return t==null?So:[t,e]}var rT=k0;function oT(n,t,e){return t==null?So:ph(t,e,Wf,!0)}function z0(n,t,e,i){return t==null?So:_h(t,e,n.scales[i].log,!1)}var aT=z0;function V0(n,t,e,i){return t==null?So:Hf(t,e,n.scales[i].log,!1)}var lT=V0;function cT(n,t,e,i,s){let r=Yn(Lg(n),Lg(t)),o=t-n,a=Li(s/i*o,e);do{let l=e[a],c=i*l/o;if(c>=s&&r+(l<5?Zs.get(l):0)<=17)return[l,c]}while(++a<e.length);return[0,0]}function e0(n){let t,e;return n=n.replace(/(\d+)px/,(i,s)=>(t=vn((e=+s)*we))+"px"),[n,t,e]}function hT(n){n.show&&[n.font,n.labelFont].forEach(t=>{let e=Ue(t[2]*we,1);t[0]=t[0].replace(/[0-9.]+px/,e+"px"),t[1]=e})}function rn(n,t,e){let i={mode:be(n.mode,1)},s=i.mode;function r(v,E,N,O){let X=E.valToPct(v);return O+N*(E.dir==-1?1-X:X)}function o(v,E,N,O){let X=E.valToPct(v);return O+N*(E.dir==-1?X:1-X)}function a(v,E,N,O){return E.ori==0?r(v,E,N,O):o(v,E,N,O)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=yi(_1);if(n.id!=null&&(c.id=n.id),hi(c,n.class),n.title){let v=yi(v1,c);v.textContent=n.title}let h=Ii("canvas"),u=i.ctx=h.getContext("2d"),f=yi(b1,c);xr("click",f,v=>{v.target===p&&(ke!=Cr||Xe!=Rr)&&Pn.click(i,v)},!0);let d=i.under=yi(S1,f);f.appendChild(h);let p=i.over=yi(M1,f);n=Mo(n);let x=+be(n.pxAlign,1),g=Kg(x);(n.plugins||[]).forEach(v=>{v.opts&&(n=v.opts(i,n)||n)});let m=n.ms||.001,_=i.series=s==1?t0(n.series||[],Wg,Zg,!1):sT(n.series||[null],Yg),w=i.axes=t0(n.axes||[],Hg,qg,!0),b=i.scales={},S=i.bands=n.bands||[];S.forEach(v=>{v.fill=xe(v.fill||null),v.dir=be(v.dir,-1)});let M=s==2?_[1].facets[0].scale:_[0].scale,y={axes:ts,series:fe},T=(n.drawOrder||["axes","series"]).map(v=>y[v]);function I(v){let E=v.distr==3?N=>vs(N>0?N:v.clamp(i,N,v.min,v.max,v.key)):v.distr==4?N=>Tf(N,v.asinh):v.distr==100?N=>v.fwd(N):N=>N;return N=>{let O=E(N),{_min:X,_max:K}=v,at=K-X;return(O-X)/at}}function P(v){let E=b[v];if(E==null){let N=(n.scales||Ga)[v]||Ga;if(N.from!=null){P(N.from);let O=dn({},b[N.from],N,{key:v});O.valToPct=I(O),b[v]=O}else{E=b[v]=dn({},v==M?R0:qA,N),E.key=v;let O=E.time,X=E.range,K=Ys(X);if((v!=M||s==2&&!O)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Rg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Rg:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&yh(X))){let at=X;X=(pt,vt,Nt)=>vt==null?So:ph(vt,Nt,at)}E.range=xe(X||(O?rT:v==M?E.distr==3?aT:E.distr==4?lT:k0:E.distr==3?z0:E.distr==4?V0:oT)),E.auto=xe(K?!1:E.auto),E.clamp=xe(E.clamp||XA),E._min=E._max=null,E.valToPct=I(E)}}}P("x"),P("y"),s==1&&_.forEach(v=>{P(v.scale)}),w.forEach(v=>{P(v.scale)});for(let v in n.scales)P(v);let R=b[M],F=R.distr,z,U;R.ori==0?(hi(c,x1),z=r,U=o):(hi(c,y1),z=o,U=r);let G={};for(let v in b){let E=b[v];(E.min!=null||E.max!=null)&&(G[v]={min:E.min,max:E.max},E.min=E.max=null)}let q=n.tzDate||(v=>new Date(vn(v/m))),H=n.fmtDate||$f,lt=m==1?xA(q):bA(q),J=zg(q,kg(m==1?_A:vA,H)),Q=Gg(q,Vg(MA,H)),it=[],dt=i.legend=dn({},TA,n.legend),ft=i.cursor=dn({},LA,{drag:{y:s==2}},n.cursor),tt=dt.show,ut=ft.show,gt=dt.markers;dt.idxs=it,gt.width=xe(gt.width),gt.dash=xe(gt.dash),gt.stroke=xe(gt.stroke),gt.fill=xe(gt.fill);let St,Mt,Ht,se=[],Vt=[],he,ae=!1,ne={};if(dt.live){let v=_[1]?_[1].values:null;ae=v!=null,he=ae?v(i,1,0):{_:0};for(let E in he)ne[E]=Vf}if(tt)if(St=Ii("table",R1,c),Ht=Ii("tbody",null,St),dt.mount(i,St),ae){Mt=Ii("thead",null,St,Ht);let v=Ii("tr",null,Mt);Ii("th",null,v);for(var We in he)Ii("th",gg,v).textContent=We}else hi(St,I1),dt.live&&hi(St,P1);let Oe={show:!0},on={show:!1};function Ie(v,E){if(E==0&&(ae||!dt.live||s==2))return So;let N=[],O=Ii("tr",L1,Ht,Ht.childNodes[E]);hi(O,v.class),v.show||hi(O,_r);let X=Ii("th",null,O);if(gt.show){let pt=yi(N1,X);if(E>0){let vt=gt.width(i,E);vt&&(pt.style.border=vt+"px "+gt.dash(i,E)+" "+gt.stroke(i,E)),pt.style.background=gt.fill(i,E)}}let K=yi(gg,X);v.label instanceof HTMLElement?K.appendChild(v.label):K.textContent=v.label,E>0&&(gt.show||(K.style.color=v.width>0?gt.stroke(i,E):gt.fill(i,E)),ye("click",X,pt=>{if(ft._lock)return;Jt(pt);let vt=_.indexOf(v);if((pt.ctrlKey||pt.metaKey)!=dt.isolate){let Nt=_.some((Dt,Ot)=>Ot>0&&Ot!=vt&&Dt.show);_.forEach((Dt,Ot)=>{Ot>0&&Fi(Ot,Nt?Ot==vt?Oe:on:Oe,!0,un.setSeries)})}else Fi(vt,{show:!v.show},!0,un.setSeries)},!1),Kt&&ye(vg,X,pt=>{ft._lock||(Jt(pt),Fi(_.indexOf(v),Ir,!0,un.setSeries))},!1));for(var at in he){let pt=Ii("td",D1,O);pt.textContent="--",N.push(pt)}return[O,N]}let Sn=new Map;function ye(v,E,N,O=!0){let X=Sn.get(E)||{},K=ft.bind[v](i,E,N,O);K&&(xr(v,E,X[v]=K),Sn.set(E,X))}function pn(v,E,N){let O=Sn.get(E)||{};for(let X in O)(v==null||X==v)&&(Nf(X,E,O[X]),delete O[X]);v==null&&Sn.delete(E)}let Ye=0,an=0,k=0,Rt=0,$t=0,re=0,wt=$t,Ne=re,zt=k,Xt=Rt,L=0,A=0,$=0,ht=0;i.bbox={};let ot=!1,xt=!1,yt=!1,et=!1,st=!1,mt=!1;function B(v,E,N){(N||v!=i.width||E!=i.height)&&rt(v,E),le(!1),yt=!0,xt=!0,Dn()}function rt(v,E){i.width=Ye=k=v,i.height=an=Rt=E,$t=re=0,bt(),Gt();let N=i.bbox;L=N.left=mr($t*we,.5),A=N.top=mr(re*we,.5),$=N.width=mr(k*we,.5),ht=N.height=mr(Rt*we,.5)}let nt=3;function At(){let v=!1,E=0;for(;!v;){E++;let N=Ar(E),O=Oi(E);v=E==nt||N&&O,v||(rt(i.width,i.height),xt=!0)}}function _t({width:v,height:E}){B(v,E)}i.setSize=_t;function bt(){let v=!1,E=!1,N=!1,O=!1;w.forEach((X,K)=>{if(X.show&&X._show){let{side:at,_size:pt}=X,vt=at%2,Nt=X.label!=null?X.labelSize:0,Dt=pt+Nt;Dt>0&&(vt?(k-=Dt,at==3?($t+=Dt,O=!0):N=!0):(Rt-=Dt,at==0?(re+=Dt,v=!0):E=!0))}}),Di[0]=v,Di[1]=N,Di[2]=E,Di[3]=O,k-=bi[1]+bi[3],$t+=bi[3],Rt-=bi[2]+bi[0],re+=bi[0]}function Gt(){let v=$t+k,E=re+Rt,N=$t,O=re;function X(K,at){switch(K){case 1:return v+=at,v-at;case 2:return E+=at,E-at;case 3:return N-=at,N+at;case 0:return O-=at,O+at}}w.forEach((K,at)=>{if(K.show&&K._show){let pt=K.side;K._pos=X(pt,K._size),K.label!=null&&(K._lpos=X(pt,K.labelSize))}})}if(ft.dataIdx==null){let v=ft.hover,E=v.skip=new Set(v.skip??[]);E.add(void 0);let N=v.prox=xe(v.prox),O=v.bias??=0;ft.dataIdx=(X,K,at,pt)=>{if(K==0)return at;let vt=at,Nt=N(X,K,at,pt)??De,Dt=Nt>=0&&Nt<De,Ot=R.ori==0?k:Rt,ie=ft.left,Se=t[0],ve=t[K];if(E.has(ve[at])){vt=null;let me=null,Zt=null,Wt;if(O==0||O==-1)for(Wt=at;me==null&&Wt-- >0;)E.has(ve[Wt])||(me=Wt);if(O==0||O==1)for(Wt=at;Zt==null&&Wt++<ve.length;)E.has(ve[Wt])||(Zt=Wt);if(me!=null||Zt!=null)if(Dt){let Ve=me==null?-1/0:z(Se[me],R,Ot,0),Ke=Zt==null?1/0:z(Se[Zt],R,Ot,0),Tn=ie-Ve,Le=Ke-ie;Tn<=Le?Tn<=Nt&&(vt=me):Le<=Nt&&(vt=Zt)}else vt=Zt==null?me:me==null?Zt:at-me<=Zt-at?me:Zt}else Dt&&bn(ie-z(Se[at],R,Ot,0))>Nt&&(vt=null);return vt}}let Jt=v=>{ft.event=v};ft.idxs=it,ft._lock=!1;let ct=ft.points;ct.show=xe(ct.show),ct.size=xe(ct.size),ct.stroke=xe(ct.stroke),ct.width=xe(ct.width),ct.fill=xe(ct.fill);let Ft=i.focus=dn({},n.focus||{alpha:.3},ft.focus),Kt=Ft.prox>=0,Ct=Kt&&ct.one,oe=[],Be=[],zn=[];function Po(v,E){let N=ct.show(i,E);if(N instanceof HTMLElement)return hi(N,C1),hi(N,v.class),Ji(N,-10,-10,k,Rt),p.insertBefore(N,oe[E]),N}function Sr(v,E){if(s==1||E>0){let N=s==1&&b[v.scale].time,O=v.value;v.value=N?Ug(O)?Gg(q,Vg(O,H)):O||Q:O||GA,v.label=v.label||(N?DA:NA)}if(Ct||E>0){v.width=v.width==null?1:v.width,v.paths=v.paths||nT||q1,v.fillTo=xe(v.fillTo||$A),v.pxAlign=+be(v.pxAlign,x),v.pxRound=Kg(v.pxAlign),v.stroke=xe(v.stroke||null),v.fill=xe(v.fill||null),v._stroke=v._fill=v._paths=v._focus=null;let N=HA(Yn(1,v.width),1),O=v.points=dn({},{size:N,width:Yn(1,N*.2),stroke:v.stroke,space:N*2,paths:iT,_stroke:null,_fill:null},v.points);O.show=xe(O.show),O.filter=xe(O.filter),O.fill=xe(O.fill),O.stroke=xe(O.stroke),O.paths=xe(O.paths),O.pxAlign=v.pxAlign}if(tt){let N=Ie(v,E);se.splice(E,0,N[0]),Vt.splice(E,0,N[1]),dt.values.push(null)}if(ut){it.splice(E,0,null);let N=null;Ct?E==0&&(N=Po(v,E)):E>0&&(N=Po(v,E)),oe.splice(E,0,N),Be.splice(E,0,0),zn.splice(E,0,0)}An("addSeries",E)}function Lh(v,E){E=E??_.length,v=s==1?kf(v,E,Wg,Zg):kf(v,E,{},Yg),_.splice(E,0,v),Sr(_[E],E)}i.addSeries=Lh;function Xa(v){if(_.splice(v,1),tt){dt.values.splice(v,1),Vt.splice(v,1);let E=se.splice(v,1)[0];pn(null,E.firstChild),E.remove()}ut&&(it.splice(v,1),oe.splice(v,1)[0].remove(),Be.splice(v,1),zn.splice(v,1)),An("delSeries",v)}i.delSeries=Xa;let Di=[!1,!1,!1,!1];function Ki(v,E){if(v._show=v.show,v.show){let N=v.side%2,O=b[v.scale];O==null&&(v.scale=N?_[1].scale:M,O=b[v.scale]);let X=O.time;v.size=xe(v.size),v.space=xe(v.space),v.rotate=xe(v.rotate),Ys(v.incrs)&&v.incrs.forEach(at=>{!Zs.has(at)&&Zs.set(at,h0(at))}),v.incrs=xe(v.incrs||(O.distr==2?pA:X?m==1?gA:yA:gr)),v.splits=xe(v.splits||(X&&O.distr==1?lt:O.distr==3?Uf:O.distr==4?FA:OA)),v.stroke=xe(v.stroke),v.grid.stroke=xe(v.grid.stroke),v.ticks.stroke=xe(v.ticks.stroke),v.border.stroke=xe(v.border.stroke);let K=v.values;v.values=Ys(K)&&!Ys(K[0])?xe(K):X?Ys(K)?zg(q,kg(K,H)):Ug(K)?SA(q,K):K||J:K||UA,v.filter=xe(v.filter||(O.distr>=3&&O.log==10?zA:O.distr==3&&O.log==2?VA:l0)),v.font=e0(v.font),v.labelFont=e0(v.labelFont),v._size=v.size(i,null,E,0),v._space=v._rotate=v._incrs=v._found=v._splits=v._values=null,v._size>0&&(Di[E]=!0,v._el=yi(w1,f))}}function ji(v,E,N,O){let[X,K,at,pt]=N,vt=E%2,Nt=0;return vt==0&&(pt||K)&&(Nt=E==0&&!X||E==2&&!at?vn(Hg.size/3):0),vt==1&&(X||at)&&(Nt=E==1&&!K||E==3&&!pt?vn(qg.size/2):0),Nt}let Io=i.padding=(n.padding||[ji,ji,ji,ji]).map(v=>xe(be(v,ji))),bi=i._padding=Io.map((v,E)=>v(i,E,Di,0)),Ze,en=null,nn=null,Ui=s==1?_[0].idxs:null,jn=null,Ms=!1;function Lo(v,E){if(t=v??[],i.data=i._data=t,s==2){Ze=0;for(let N=1;N<_.length;N++)Ze+=t[N][0].length}else{t.length==0&&(i.data=i._data=t=[[]]),jn=t[0],Ze=jn.length;let N=t;if(F==2){N=t.slice();let O=N[0]=Array(Ze);for(let X=0;X<Ze;X++)O[X]=X}i._data=t=N}if(le(!0),An("setData"),F==2&&(yt=!0),E!==!1){let N=R;N.auto(i,Ms)?No():Ts(M,N.min,N.max),et=et||ft.left>=0,mt=!0,Dn()}}i.setData=Lo;function No(){Ms=!0;let v,E;s==1&&(Ze>0?(en=Ui[0]=0,nn=Ui[1]=Ze-1,v=t[0][en],E=t[0][nn],F==2?(v=en,E=nn):v==E&&(F==3?[v,E]=_h(v,v,R.log,!1):F==4?[v,E]=Hf(v,v,R.log,!1):R.time?E=v+vn(86400/m):[v,E]=ph(v,E,Wf,!0))):(en=Ui[0]=v=null,nn=Ui[1]=E=null)),Ts(M,v,E)}let Mr,ws,wr,C,V,j,Y,Z,Tt,Pt;function Et(v,E,N,O,X,K){v??=xg,N??=qf,O??="butt",X??=xg,K??="round",v!=Mr&&(u.strokeStyle=Mr=v),X!=ws&&(u.fillStyle=ws=X),E!=wr&&(u.lineWidth=wr=E),K!=V&&(u.lineJoin=V=K),O!=j&&(u.lineCap=j=O),N!=C&&u.setLineDash(C=N)}function It(v,E,N,O){E!=ws&&(u.fillStyle=ws=E),v!=Y&&(u.font=Y=v),N!=Z&&(u.textAlign=Z=N),O!=Tt&&(u.textBaseline=Tt=O)}function kt(v,E,N,O,X=0){if(O.length>0&&v.auto(i,Ms)&&(E==null||E.min==null)){let K=be(en,0),at=be(nn,O.length-1),pt=N.min==null?z1(O,K,at,X,v.distr==3):[N.min,N.max];v.min=Ni(v.min,N.min=pt[0]),v.max=Yn(v.max,N.max=pt[1])}}let te={min:null,max:null};function ue(){for(let O in b){let X=b[O];G[O]==null&&(X.min==null||G[M]!=null&&X.auto(i,Ms))&&(G[O]=te)}for(let O in b){let X=b[O];G[O]==null&&X.from!=null&&G[X.from]!=null&&(G[O]=te)}G[M]!=null&&le(!0);let v={};for(let O in G){let X=G[O];if(X!=null){let K=v[O]=Mo(b[O],Z1);if(X.min!=null)dn(K,X);else if(O!=M||s==2)if(Ze==0&&K.from==null){let at=K.range(i,null,null,O);K.min=at[0],K.max=at[1]}else K.min=De,K.max=-De}}if(Ze>0){_.forEach((O,X)=>{if(s==1){let K=O.scale,at=G[K];if(at==null)return;let pt=v[K];if(X==0){let vt=pt.range(i,pt.min,pt.max,K);pt.min=vt[0],pt.max=vt[1],en=Li(pt.min,t[0]),nn=Li(pt.max,t[0]),nn-en>1&&(t[0][en]<pt.min&&en++,t[0][nn]>pt.max&&nn--),O.min=jn[en],O.max=jn[nn]}else O.show&&O.auto&&kt(pt,at,O,t[X],O.sorted);O.idxs[0]=en,O.idxs[1]=nn}else if(X>0&&O.show&&O.auto){let[K,at]=O.facets,pt=K.scale,vt=at.scale,[Nt,Dt]=t[X],Ot=v[pt],ie=v[vt];Ot!=null&&kt(Ot,G[pt],K,Nt,K.sorted),ie!=null&&kt(ie,G[vt],at,Dt,at.sorted),O.min=at.min,O.max=at.max}});for(let O in v){let X=v[O],K=G[O];if(X.from==null&&(K==null||K.min==null)){let at=X.range(i,X.min==De?null:X.min,X.max==-De?null:X.max,O);X.min=at[0],X.max=at[1]}}}for(let O in v){let X=v[O];if(X.from!=null){let K=v[X.from];if(K.min==null)X.min=X.max=null;else{let at=X.range(i,K.min,K.max,O);X.min=at[0],X.max=at[1]}}}let E={},N=!1;for(let O in v){let X=v[O],K=b[O];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let at=K.distr;K._min=at==3?vs(K.min):at==4?Tf(K.min,K.asinh):at==100?K.fwd(K.min):K.min,K._max=at==3?vs(K.max):at==4?Tf(K.max,K.asinh):at==100?K.fwd(K.max):K.max,E[O]=N=!0}}if(N){_.forEach((O,X)=>{s==2?X>0&&E.y&&(O._paths=null):E[O.scale]&&(O._paths=null)});for(let O in E)yt=!0,An("setScale",O);ut&&ft.left>=0&&(et=mt=!0)}for(let O in G)G[O]=null}function Bt(v){let E=Df(en-1,0,Ze-1),N=Df(nn+1,0,Ze-1);for(;v[E]==null&&E>0;)E--;for(;v[N]==null&&N<Ze-1;)N++;return[E,N]}function fe(){if(Ze>0){let v=_.some(E=>E._focus)&&Pt!=Ft.alpha;v&&(u.globalAlpha=Pt=Ft.alpha),_.forEach((E,N)=>{if(N>0&&E.show&&($e(N,!1),$e(N,!0),E._paths==null)){let O=Pt;Pt!=E.alpha&&(u.globalAlpha=Pt=E.alpha);let X=s==2?[0,t[N][0].length-1]:Bt(t[N]);E._paths=E.paths(i,N,X[0],X[1]),Pt!=O&&(u.globalAlpha=Pt=O)}}),_.forEach((E,N)=>{if(N>0&&E.show){let O=Pt;Pt!=E.alpha&&(u.globalAlpha=Pt=E.alpha),E._paths!=null&&Ce(N,!1);{let X=E._paths!=null?E._paths.gaps:null,K=E.points.show(i,N,en,nn,X),at=E.points.filter(i,N,K,X);(K||at)&&(E.points._paths=E.points.paths(i,N,en,nn,at),Ce(N,!0))}Pt!=O&&(u.globalAlpha=Pt=O),An("drawSeries",N)}}),v&&(u.globalAlpha=Pt=1)}}function $e(v,E){let N=E?_[v].points:_[v];N._stroke=N.stroke(i,v),N._fill=N.fill(i,v)}function Ce(v,E){let N=E?_[v].points:_[v],{stroke:O,fill:X,clip:K,flags:at,_stroke:pt=N._stroke,_fill:vt=N._fill,_width:Nt=N.width}=N._paths;Nt=Ue(Nt*we,3);let Dt=null,Ot=Nt%2/2;E&&vt==null&&(vt=Nt>0?"#fff":pt);let ie=N.pxAlign==1&&Ot>0;if(ie&&u.translate(Ot,Ot),!E){let Se=L-Nt/2,ve=A-Nt/2,me=$+Nt,Zt=ht+Nt;Dt=new Path2D,Dt.rect(Se,ve,me,Zt)}E?Ut(pt,Nt,N.dash,N.cap,vt,O,X,at,K):Re(v,pt,Nt,N.dash,N.cap,vt,O,X,at,Dt,K),ie&&u.translate(-Ot,-Ot)}function Re(v,E,N,O,X,K,at,pt,vt,Nt,Dt){let Ot=!1;vt!=0&&S.forEach((ie,Se)=>{if(ie.series[0]==v){let ve=_[ie.series[1]],me=t[ie.series[1]],Zt=(ve._paths||Ga).band;Ys(Zt)&&(Zt=ie.dir==1?Zt[0]:Zt[1]);let Wt,Ve=null;ve.show&&Zt&&G1(me,en,nn)?(Ve=ie.fill(i,Se)||K,Wt=ve._paths.clip):Zt=null,Ut(E,N,O,X,Ve,at,pt,vt,Nt,Dt,Wt,Zt),Ot=!0}}),Ot||Ut(E,N,O,X,K,at,pt,vt,Nt,Dt)}let mn=wo|Ff;function Ut(v,E,N,O,X,K,at,pt,vt,Nt,Dt,Ot){Et(v,E,N,O,X),(vt||Nt||Ot)&&(u.save(),vt&&u.clip(vt),Nt&&u.clip(Nt)),Ot?(pt&mn)==mn?(u.clip(Ot),Dt&&u.clip(Dt),ge(X,at),ln(v,K,E)):pt&Ff?(ge(X,at),u.clip(Ot),ln(v,K,E)):pt&wo&&(u.save(),u.clip(Ot),Dt&&u.clip(Dt),ge(X,at),u.restore(),ln(v,K,E)):(ge(X,at),ln(v,K,E)),(vt||Nt||Ot)&&u.restore()}function ln(v,E,N){N>0&&(E instanceof Map?E.forEach((O,X)=>{u.strokeStyle=Mr=X,u.stroke(O)}):E!=null&&v&&u.stroke(E))}function ge(v,E){E instanceof Map?E.forEach((N,O)=>{u.fillStyle=ws=O,u.fill(N)}):E!=null&&v&&u.fill(E)}function Qi(v,E,N,O){let X=w[v],K;if(O<=0)K=[0,0];else{let at=X._space=X.space(i,v,E,N,O),pt=X._incrs=X.incrs(i,v,E,N,O,at);K=cT(E,N,pt,O,at)}return X._found=K}function cn(v,E,N,O,X,K,at,pt,vt,Nt){let Dt=at%2/2;x==1&&u.translate(Dt,Dt),Et(pt,at,vt,Nt,pt),u.beginPath();let Ot,ie,Se,ve,me=X+(O==0||O==3?-K:K);N==0?(ie=X,ve=me):(Ot=X,Se=me);for(let Zt=0;Zt<v.length;Zt++)E[Zt]!=null&&(N==0?Ot=Se=v[Zt]:ie=ve=v[Zt],u.moveTo(Ot,ie),u.lineTo(Se,ve));u.stroke(),x==1&&u.translate(-Dt,-Dt)}function Ar(v){let E=!0;return w.forEach((N,O)=>{if(!N.show)return;let X=b[N.scale];if(X.min==null){N._show&&(E=!1,N._show=!1,le(!1));return}else N._show||(E=!1,N._show=!0,le(!1));let K=N.side,at=K%2,{min:pt,max:vt}=X,[Nt,Dt]=Qi(O,pt,vt,at==0?k:Rt);if(Dt==0)return;let Ot=X.distr==2,ie=N._splits=N.splits(i,O,pt,vt,Nt,Dt,Ot),Se=X.distr==2?ie.map(Wt=>jn[Wt]):ie,ve=X.distr==2?jn[ie[1]]-jn[ie[0]]:Nt,me=N._values=N.values(i,N.filter(i,Se,O,Dt,ve),O,Dt,ve);N._rotate=K==2?N.rotate(i,me,O,Dt):0;let Zt=N._size;N._size=vi(N.size(i,me,O,v)),Zt!=null&&N._size!=Zt&&(E=!1)}),E}function Oi(v){let E=!0;return Io.forEach((N,O)=>{let X=N(i,O,Di,v);X!=bi[O]&&(E=!1),bi[O]=X}),E}function ts(){for(let v=0;v<w.length;v++){let E=w[v];if(!E.show||!E._show)continue;let N=E.side,O=N%2,X,K,at=E.stroke(i,v),pt=N==0||N==3?-1:1,[vt,Nt]=E._found;if(E.label!=null){let Hn=E.labelGap*pt,ei=vn((E._lpos+Hn)*we);It(E.labelFont[0],at,"center",N==2?"top":_g),u.save(),O==1?(X=K=0,u.translate(ei,vn(A+ht/2)),u.rotate((N==3?-fh:fh)/2)):(X=vn(L+$/2),K=ei);let Qs=o0(E.label)?E.label(i,v,vt,Nt):E.label;u.fillText(Qs,X,K),u.restore()}if(Nt==0)continue;let Dt=b[E.scale],Ot=O==0?$:ht,ie=O==0?L:A,Se=E._splits,ve=Dt.distr==2?Se.map(Hn=>jn[Hn]):Se,me=Dt.distr==2?jn[Se[1]]-jn[Se[0]]:vt,Zt=E.ticks,Wt=E.border,Ve=Zt.show?Zt.size:0,Ke=vn(Ve*we),Tn=vn((E.alignTo==2?E._size-Ve-E.gap:E.gap)*we),Le=E._rotate*-fh/180,je=g(E._pos*we),Qn=(Ke+Tn)*pt,Gn=je+Qn;K=O==0?Gn:0,X=O==1?Gn:0;let di=E.font[0],Si=E.align==1?xo:E.align==2?Mf:Le>0?xo:Le<0?Mf:O==0?"center":N==3?Mf:xo,ki=Le||O==1?"middle":N==2?"top":_g;It(di,at,Si,ki);let ti=E.font[1]*E.lineGap,pi=Se.map(Hn=>g(a(Hn,Dt,Ot,ie))),Mi=E._values;for(let Hn=0;Hn<Mi.length;Hn++){let ei=Mi[Hn];if(ei!=null){O==0?X=pi[Hn]:K=pi[Hn],ei=""+ei;let Qs=ei.indexOf(`
`)==-1?[ei]:ei.split(/\n/gm);for(let Wn=0;Wn<Qs.length;Wn++){let Rd=Qs[Wn];Le?(u.save(),u.translate(X,K+Wn*ti),u.rotate(Le),u.fillText(Rd,0,0),u.restore()):u.fillText(Rd,X,K+Wn*ti)}}}Zt.show&&cn(pi,Zt.filter(i,ve,v,Nt,me),O,N,je,Ke,Ue(Zt.width*we,3),Zt.stroke(i,v),Zt.dash,Zt.cap);let zi=E.grid;zi.show&&cn(pi,zi.filter(i,ve,v,Nt,me),O,O==0?2:1,O==0?A:L,O==0?ht:$,Ue(zi.width*we,3),zi.stroke(i,v),zi.dash,zi.cap),Wt.show&&cn([je],[1],O==0?1:0,O==0?1:2,O==1?A:L,O==1?ht:$,Ue(Wt.width*we,3),Wt.stroke(i,v),Wt.dash,Wt.cap)}An("drawAxes")}function le(v){_.forEach((E,N)=>{N>0&&(E._paths=null,v&&(s==1?(E.min=null,E.max=null):E.facets.forEach(O=>{O.min=null,O.max=null})))})}let Je=!1,Vn=!1,Pe=[];function hn(){Vn=!1;for(let v=0;v<Pe.length;v++)An(...Pe[v]);Pe.length=0}function Dn(){Je||(nA(ud),Je=!0)}function qa(v,E=!1){Je=!0,Vn=E,v(i),ud(),E&&Pe.length>0&&queueMicrotask(hn)}i.batch=qa;function ud(){if(ot&&(ue(),ot=!1),yt&&(At(),yt=!1),xt){if(He(d,xo,$t),He(d,"top",re),He(d,Ba,k),He(d,ka,Rt),He(p,xo,$t),He(p,"top",re),He(p,Ba,k),He(p,ka,Rt),He(f,Ba,Ye),He(f,ka,an),h.width=vn(Ye*we),h.height=vn(an*we),w.forEach(({_el:v,_show:E,_size:N,_pos:O,side:X})=>{if(v!=null)if(E){let K=X===3||X===0?N:0,at=X%2==1;He(v,at?"left":"top",O-K),He(v,at?"width":"height",N),He(v,at?"top":"left",at?re:$t),He(v,at?"height":"width",at?Rt:k),Lf(v,_r)}else hi(v,_r)}),Mr=ws=wr=V=j=Y=Z=Tt=C=null,Pt=1,Oo(!0),$t!=wt||re!=Ne||k!=zt||Rt!=Xt){le(!1);let v=k/zt,E=Rt/Xt;if(ut&&!et&&ft.left>=0){ft.left*=v,ft.top*=E,Tr&&Ji(Tr,vn(ft.left),0,k,Rt),Er&&Ji(Er,0,vn(ft.top),k,Rt);for(let N=0;N<oe.length;N++){let O=oe[N];O!=null&&(Be[N]*=v,zn[N]*=E,Ji(O,vi(Be[N]),vi(zn[N]),k,Rt))}}if(ze.show&&!st&&ze.left>=0&&ze.width>0){ze.left*=v,ze.width*=v,ze.top*=E,ze.height*=E;for(let N in Bh)He(Pr,N,ze[N])}wt=$t,Ne=re,zt=k,Xt=Rt}An("setSize"),xt=!1}Ye>0&&an>0&&(u.clearRect(0,0,h.width,h.height),An("drawClear"),T.forEach(v=>v()),An("draw")),ze.show&&st&&($a(ze),st=!1),ut&&et&&(js(null,!0,!1),et=!1),dt.show&&dt.live&&mt&&(Oh(),mt=!1),l||(l=!0,i.status=1,An("ready")),Ms=!1,Je=!1}i.redraw=(v,E)=>{yt=E||!1,v!==!1?Ts(M,R.min,R.max):Dn()};function Nh(v,E){let N=b[v];if(N.from==null){if(Ze==0){let O=N.range(i,E.min,E.max,v);E.min=O[0],E.max=O[1]}if(E.min>E.max){let O=E.min;E.min=E.max,E.max=O}if(Ze>1&&E.min!=null&&E.max!=null&&E.max-E.min<1e-16)return;v==M&&N.distr==2&&Ze>0&&(E.min=Li(E.min,t[0]),E.max=Li(E.max,t[0]),E.min==E.max&&E.max++),G[v]=E,ot=!0,Dn()}}i.setScale=Nh;let Dh,Uh,Tr,Er,fd,dd,Cr,Rr,pd,md,ke,Xe,As=!1,Pn=ft.drag,Mn=Pn.x,wn=Pn.y;ut&&(ft.x&&(Dh=yi(T1,p)),ft.y&&(Uh=yi(E1,p)),R.ori==0?(Tr=Dh,Er=Uh):(Tr=Uh,Er=Dh),ke=ft.left,Xe=ft.top);let ze=i.select=dn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Pr=ze.show?yi(A1,ze.over?p:d):null;function $a(v,E){if(ze.show){for(let N in v)ze[N]=v[N],N in Bh&&He(Pr,N,v[N]);E!==!1&&An("setSelect")}}i.setSelect=$a;function z_(v){if(_[v].show)tt&&Lf(se[v],_r);else if(tt&&hi(se[v],_r),ut){let N=Ct?oe[0]:oe[v];N!=null&&Ji(N,-10,-10,k,Rt)}}function Ts(v,E,N){Nh(v,{min:E,max:N})}function Fi(v,E,N,O){E.focus!=null&&X_(v),E.show!=null&&_.forEach((X,K)=>{K>0&&(v==K||v==null)&&(X.show=E.show,z_(K),s==2?(Ts(X.facets[0].scale,null,null),Ts(X.facets[1].scale,null,null)):Ts(X.scale,null,null),Dn())}),N!==!1&&An("setSeries",v,E),O&&Fo("setSeries",i,v,E)}i.setSeries=Fi;function V_(v,E){dn(S[v],E)}function G_(v,E){v.fill=xe(v.fill||null),v.dir=be(v.dir,-1),E=E??S.length,S.splice(E,0,v)}function H_(v){v==null?S.length=0:S.splice(v,1)}i.addBand=G_,i.setBand=V_,i.delBand=H_;function W_(v,E){_[v].alpha=E,ut&&oe[v]!=null&&(oe[v].style.opacity=E),tt&&se[v]&&(se[v].style.opacity=E)}let es,Es,Ks,Ir={focus:!0};function X_(v){if(v!=Ks){let E=v==null,N=Ft.alpha!=1;_.forEach((O,X)=>{if(s==1||X>0){let K=E||X==0||X==v;O._focus=E?null:K,N&&W_(X,K?1:Ft.alpha)}}),Ks=v,N&&Dn()}}tt&&Kt&&ye(bg,St,v=>{ft._lock||(Jt(v),Ks!=null&&Fi(null,Ir,!0,un.setSeries))});function Bi(v,E,N){let O=b[E];N&&(v=v/we-(O.ori==1?re:$t));let X=k;O.ori==1&&(X=Rt,v=X-v),O.dir==-1&&(v=X-v);let K=O._min,at=O._max,pt=v/X,vt=K+(at-K)*pt,Nt=O.distr;return Nt==3?bo(10,vt):Nt==4?W1(vt,O.asinh):Nt==100?O.bwd(vt):vt}function q_(v,E){let N=Bi(v,M,E);return Li(N,t[0],en,nn)}i.valToIdx=v=>Li(v,t[0]),i.posToIdx=q_,i.posToVal=Bi,i.valToPos=(v,E,N)=>b[E].ori==0?r(v,b[E],N?$:k,N?L:0):o(v,b[E],N?ht:Rt,N?A:0),i.setCursor=(v,E,N)=>{ke=v.left,Xe=v.top,js(null,E,N)};function gd(v,E){He(Pr,xo,ze.left=v),He(Pr,Ba,ze.width=E)}function _d(v,E){He(Pr,"top",ze.top=v),He(Pr,ka,ze.height=E)}let Do=R.ori==0?gd:_d,Uo=R.ori==1?gd:_d;function $_(){if(tt&&dt.live)for(let v=s==2?1:0;v<_.length;v++){if(v==0&&ae)continue;let E=dt.values[v],N=0;for(let O in E)Vt[v][N++].firstChild.nodeValue=E[O]}}function Oh(v,E){if(v!=null&&(v.idxs?v.idxs.forEach((N,O)=>{it[O]=N}):Y1(v.idx)||it.fill(v.idx),dt.idx=it[0]),tt&&dt.live){for(let N=0;N<_.length;N++)(N>0||s==1&&!ae)&&Y_(N,it[N]);$_()}mt=!1,E!==!1&&An("setLegend")}i.setLegend=Oh;function Y_(v,E){let N=_[v],O=v==0&&F==2?jn:t[v],X;ae?X=N.values(i,v,E)??ne:(X=N.value(i,E==null?null:O[E],v,E),X=X==null?ne:{_:X}),dt.values[v]=X}function js(v,E,N){pd=ke,md=Xe,[ke,Xe]=ft.move(i,ke,Xe),ft.left=ke,ft.top=Xe,ut&&(Tr&&Ji(Tr,vn(ke),0,k,Rt),Er&&Ji(Er,0,vn(Xe),k,Rt));let O,X=en>nn;es=De,Es=null;let K=R.ori==0?k:Rt,at=R.ori==1?k:Rt;if(ke<0||Ze==0||X){O=ft.idx=null;for(let pt=0;pt<_.length;pt++){let vt=oe[pt];vt!=null&&Ji(vt,-10,-10,k,Rt)}Kt&&Fi(null,Ir,!0,v==null&&un.setSeries),dt.live&&(it.fill(O),mt=!0)}else{let pt,vt,Nt;s==1&&(pt=R.ori==0?ke:Xe,vt=Bi(pt,M),O=ft.idx=Li(vt,t[0],en,nn),Nt=z(t[0][O],R,K,0));let Dt=-10,Ot=-10,ie=0,Se=0,ve=!0,me="",Zt="";for(let Wt=s==2?1:0;Wt<_.length;Wt++){let Ve=_[Wt],Ke=it[Wt],Tn=Ke==null?null:s==1?t[Wt][Ke]:t[Wt][1][Ke],Le=ft.dataIdx(i,Wt,O,vt),je=Le==null?null:s==1?t[Wt][Le]:t[Wt][1][Le];if(mt=mt||je!=Tn||Le!=Ke,it[Wt]=Le,Wt>0&&Ve.show){let Qn=Le==null?-10:Le==O?Nt:z(s==1?t[0][Le]:t[Wt][0][Le],R,K,0),Gn=je==null?-10:U(je,s==1?b[Ve.scale]:b[Ve.facets[1].scale],at,0);if(Kt&&je!=null){let di=R.ori==1?ke:Xe,Si=bn(Ft.dist(i,Wt,Le,Gn,di));if(Si<es){let ki=Ft.bias;if(ki!=0){let ti=Bi(di,Ve.scale),pi=je>=0?1:-1,Mi=ti>=0?1:-1;Mi==pi&&(Mi==1?ki==1?je>=ti:je<=ti:ki==1?je<=ti:je>=ti)&&(es=Si,Es=Wt)}else es=Si,Es=Wt}}if(mt||Ct){let di,Si;R.ori==0?(di=Qn,Si=Gn):(di=Gn,Si=Qn);let ki,ti,pi,Mi,zi,Hn,ei=!0,Qs=ct.bbox;if(Qs!=null){ei=!1;let Wn=Qs(i,Wt);pi=Wn.left,Mi=Wn.top,ki=Wn.width,ti=Wn.height}else pi=di,Mi=Si,ki=ti=ct.size(i,Wt);if(Hn=ct.fill(i,Wt),zi=ct.stroke(i,Wt),Ct)Wt==Es&&es<=Ft.prox&&(Dt=pi,Ot=Mi,ie=ki,Se=ti,ve=ei,me=Hn,Zt=zi);else{let Wn=oe[Wt];Wn!=null&&(Be[Wt]=pi,zn[Wt]=Mi,Cg(Wn,ki,ti,ei),Tg(Wn,Hn,zi),Ji(Wn,vi(pi),vi(Mi),k,Rt))}}}}if(Ct){let Wt=Ft.prox,Ve=Ks==null?es<=Wt:es>Wt||Es!=Ks;if(mt||Ve){let Ke=oe[0];Ke!=null&&(Be[0]=Dt,zn[0]=Ot,Cg(Ke,ie,Se,ve),Tg(Ke,me,Zt),Ji(Ke,vi(Dt),vi(Ot),k,Rt))}}}if(ze.show&&As)if(v!=null){let[pt,vt]=un.scales,[Nt,Dt]=un.match,[Ot,ie]=v.cursor.sync.scales,Se=v.cursor.drag;if(Mn=Se._x,wn=Se._y,Mn||wn){let{left:ve,top:me,width:Zt,height:Wt}=v.select,Ve=v.scales[Ot].ori,Ke=v.posToVal,Tn,Le,je,Qn,Gn,di=pt!=null&&Nt(pt,Ot),Si=vt!=null&&Dt(vt,ie);di&&Mn?(Ve==0?(Tn=ve,Le=Zt):(Tn=me,Le=Wt),je=b[pt],Qn=z(Ke(Tn,Ot),je,K,0),Gn=z(Ke(Tn+Le,Ot),je,K,0),Do(Ni(Qn,Gn),bn(Gn-Qn))):Do(0,K),Si&&wn?(Ve==1?(Tn=ve,Le=Zt):(Tn=me,Le=Wt),je=b[vt],Qn=U(Ke(Tn,ie),je,at,0),Gn=U(Ke(Tn+Le,ie),je,at,0),Uo(Ni(Qn,Gn),bn(Gn-Qn))):Uo(0,at)}else kh()}else{let pt=bn(pd-fd),vt=bn(md-dd);if(R.ori==1){let ie=pt;pt=vt,vt=ie}Mn=Pn.x&&pt>=Pn.dist,wn=Pn.y&&vt>=Pn.dist;let Nt=Pn.uni;Nt!=null?Mn&&wn&&(Mn=pt>=Nt,wn=vt>=Nt,!Mn&&!wn&&(vt>pt?wn=!0:Mn=!0)):Pn.x&&Pn.y&&(Mn||wn)&&(Mn=wn=!0);let Dt,Ot;Mn&&(R.ori==0?(Dt=Cr,Ot=ke):(Dt=Rr,Ot=Xe),Do(Ni(Dt,Ot),bn(Ot-Dt)),wn||Uo(0,at)),wn&&(R.ori==1?(Dt=Cr,Ot=ke):(Dt=Rr,Ot=Xe),Uo(Ni(Dt,Ot),bn(Ot-Dt)),Mn||Do(0,K)),!Mn&&!wn&&(Do(0,0),Uo(0,0))}if(Pn._x=Mn,Pn._y=wn,v==null){if(N){if(Cd!=null){let[pt,vt]=un.scales;un.values[0]=pt!=null?Bi(R.ori==0?ke:Xe,pt):null,un.values[1]=vt!=null?Bi(R.ori==1?ke:Xe,vt):null}Fo(wf,i,ke,Xe,k,Rt,O)}if(Kt){let pt=N&&un.setSeries,vt=Ft.prox;Ks==null?es<=vt&&Fi(Es,Ir,!0,pt):es>vt?Fi(null,Ir,!0,pt):Es!=Ks&&Fi(Es,Ir,!0,pt)}}mt&&(dt.idx=O,Oh()),E!==!1&&An("setCursor")}let Cs=null;Object.defineProperty(i,"rect",{get(){return Cs==null&&Oo(!1),Cs}});function Oo(v=!1){v?Cs=null:(Cs=p.getBoundingClientRect(),An("syncRect",Cs))}function xd(v,E,N,O,X,K,at){ft._lock||As&&v!=null&&v.movementX==0&&v.movementY==0||(Fh(v,E,N,O,X,K,at,!1,v!=null),v!=null?js(null,!0,!0):js(E,!0,!1))}function Fh(v,E,N,O,X,K,at,pt,vt){if(Cs==null&&Oo(!1),Jt(v),v!=null)N=v.clientX-Cs.left,O=v.clientY-Cs.top;else{if(N<0||O<0){ke=-10,Xe=-10;return}let[Nt,Dt]=un.scales,Ot=E.cursor.sync,[ie,Se]=Ot.values,[ve,me]=Ot.scales,[Zt,Wt]=un.match,Ve=E.axes[0].side%2==1,Ke=R.ori==0?k:Rt,Tn=R.ori==1?k:Rt,Le=Ve?K:X,je=Ve?X:K,Qn=Ve?O:N,Gn=Ve?N:O;if(ve!=null?N=Zt(Nt,ve)?a(ie,b[Nt],Ke,0):-10:N=Ke*(Qn/Le),me!=null?O=Wt(Dt,me)?a(Se,b[Dt],Tn,0):-10:O=Tn*(Gn/je),R.ori==1){let di=N;N=O,O=di}}vt&&(E==null||E.cursor.event.type==wf)&&((N<=1||N>=k-1)&&(N=mr(N,k)),(O<=1||O>=Rt-1)&&(O=mr(O,Rt))),pt?(fd=N,dd=O,[Cr,Rr]=ft.move(i,N,O)):(ke=N,Xe=O)}let Bh={width:0,height:0,left:0,top:0};function kh(){$a(Bh,!1)}let yd,vd,bd,Sd;function Md(v,E,N,O,X,K,at){As=!0,Mn=wn=Pn._x=Pn._y=!1,Fh(v,E,N,O,X,K,at,!0,!1),v!=null&&(ye(Af,Pf,wd,!1),Fo(yg,i,Cr,Rr,k,Rt,null));let{left:pt,top:vt,width:Nt,height:Dt}=ze;yd=pt,vd=vt,bd=Nt,Sd=Dt}function wd(v,E,N,O,X,K,at){As=Pn._x=Pn._y=!1,Fh(v,E,N,O,X,K,at,!1,!0);let{left:pt,top:vt,width:Nt,height:Dt}=ze,Ot=Nt>0||Dt>0,ie=yd!=pt||vd!=vt||bd!=Nt||Sd!=Dt;if(Ot&&ie&&$a(ze),Pn.setScale&&Ot&&ie){let Se=pt,ve=Nt,me=vt,Zt=Dt;if(R.ori==1&&(Se=vt,ve=Dt,me=pt,Zt=Nt),Mn&&Ts(M,Bi(Se,M),Bi(Se+ve,M)),wn)for(let Wt in b){let Ve=b[Wt];Wt!=M&&Ve.from==null&&Ve.min!=De&&Ts(Wt,Bi(me+Zt,Wt),Bi(me,Wt))}kh()}else ft.lock&&(ft._lock=!ft._lock,js(E,!0,v!=null));v!=null&&(pn(Af,Pf),Fo(Af,i,ke,Xe,k,Rt,null))}function Z_(v,E,N,O,X,K,at){if(ft._lock)return;Jt(v);let pt=As;if(As){let vt=!0,Nt=!0,Dt=10,Ot,ie;R.ori==0?(Ot=Mn,ie=wn):(Ot=wn,ie=Mn),Ot&&ie&&(vt=ke<=Dt||ke>=k-Dt,Nt=Xe<=Dt||Xe>=Rt-Dt),Ot&&vt&&(ke=ke<Cr?0:k),ie&&Nt&&(Xe=Xe<Rr?0:Rt),js(null,!0,!0),As=!1}ke=-10,Xe=-10,it.fill(null),js(null,!0,!0),pt&&(As=pt)}function Ad(v,E,N,O,X,K,at){ft._lock||(Jt(v),No(),kh(),v!=null&&Fo(Sg,i,ke,Xe,k,Rt,null))}function Td(){w.forEach(hT),B(i.width,i.height,!0)}xr(dh,vo,Td);let Lr={};Lr.mousedown=Md,Lr.mousemove=xd,Lr.mouseup=wd,Lr.dblclick=Ad,Lr.setSeries=(v,E,N,O)=>{let X=un.match[2];N=X(i,E,N),N!=-1&&Fi(N,O,!0,!1)},ut&&(ye(yg,p,Md),ye(wf,p,xd),ye(vg,p,v=>{Jt(v),Oo(!1)}),ye(bg,p,Z_),ye(Sg,p,Ad),Bf.add(i),i.syncRect=Oo);let Ya=i.hooks=n.hooks||{};function An(v,E,N){Vn?Pe.push([v,E,N]):v in Ya&&Ya[v].forEach(O=>{O.call(null,i,E,N)})}(n.plugins||[]).forEach(v=>{for(let E in v.hooks)Ya[E]=(Ya[E]||[]).concat(v.hooks[E])});let Ed=(v,E,N)=>N,un=dn({key:null,setSeries:!1,filters:{pub:Ng,sub:Ng},scales:[M,_[1]?_[1].scale:null],match:[Dg,Dg,Ed],values:[null,null]},ft.sync);un.match.length==2&&un.match.push(Ed),ft.sync=un;let Cd=un.key,zh=P0(Cd);function Fo(v,E,N,O,X,K,at){un.filters.pub(v,E,N,O,X,K,at)&&zh.pub(v,E,N,O,X,K,at)}zh.sub(i);function J_(v,E,N,O,X,K,at){un.filters.sub(v,E,N,O,X,K,at)&&Lr[v](null,E,N,O,X,K,at)}i.pub=J_;function K_(){zh.unsub(i),Bf.delete(i),Sn.clear(),Nf(dh,vo,Td),c.remove(),St?.remove(),An("destroy")}i.destroy=K_;function Vh(){An("init",n,t),Lo(t||n.data,!1),G[M]?Nh(M,G[M]):No(),st=ze.show&&(ze.width>0||ze.height>0),et=mt=!0,B(n.width,n.height)}return _.forEach(Sr),w.forEach(Ki),e?e instanceof HTMLElement?(e.appendChild(c),Vh()):e(i,Vh):Vh(),i}rn.assign=dn;rn.fmtNum=Xf;rn.rangeNum=ph;rn.rangeLog=_h;rn.rangeAsinh=Hf;rn.orient=vr;rn.pxRatio=we;rn.join=eA;rn.fmtDate=$f,rn.tzDate=fA;rn.sync=P0;{rn.addGap=YA,rn.clipGaps=vh;let n=rn.paths={points:O0};n.linear=B0,n.stepped=KA,n.bars=jA,n.spline=tT}var wh=210,uT=64,fT=[.01,.02,.05,.1,.2,.5,1,2,5,10,15,30,45,90,180,360,...MT(3,20)];function Co(n,t,e,i){let s=t.map(o=>dT(o,e)),r=t.map((o,a)=>{let l=o.sharing?s.filter((c,h)=>t[h].sharing===o.sharing).flat():null;return mT(o,s[a].map(c=>c.values),l,e,i)});n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return{charts:r.map(o=>o.chart),dispose:()=>r.forEach(o=>o.dispose())}}function dT(n,t){return n.lines.map(e=>({clip:e.clip,values:e.readings?t[e.clip].line(e.readings,e.part):tn(e.values,Float32Array)}))}function pT(n,t,e){let i=[0,0];for(let{clip:s,values:r}of n){let o=t[s].time;for(let a=0;a<o.length;a++){let l=o[a]-e.origins[s];l<e.start||l>e.end||(r[a]<i[0]&&(i[0]=r[a]),r[a]>i[1]&&(i[1]=r[a]))}}return i}function td(n){let[t,...e]=n.lines.map(i=>i.clip);return e.every(i=>i===t)?t??null:null}function mT(n,t,e,i,s){let{element:r,key:o,place:a}=ed(n,n.owner),l=D("div",{className:"cursor"}),c=null,h=null,u=!1,f=[],d=new ResizeObserver(()=>c?.setSize({width:a.clientWidth,height:wh}));function p(){let{word:_}=n,w=n.lines.map((b,S)=>D("li",{},tr(_s(S)),_?b.name.slice(_.length+1):b.name));o.replaceChildren(..._?[D("li",{},_)]:[],...w)}function x(){(s.span!==h||s.stretched!==u)&&(h=s.span,u=s.stretched,c.setData(G0(n,t,i,h),!1),c.setScale("x",{min:h.start,max:h.end})),l.style.transform=`translateX(${c.valToPos(s.time,"x").toFixed(2)}px)`}function g(){h=s.span,u=s.stretched,c=new rn(gT(n,e,i,s,a.clientWidth),G0(n,t,i,h),a),c.setScale("x",{min:h.start,max:h.end}),c.over.append(l),ST(c,s),d.observe(a),c.hooks.setSize=[x];let _=()=>{p(),c.redraw(!1)};f=[s.onChange(x),Xs(_)],p()}function m(){for(let _ of f)_();d.disconnect(),c.destroy()}return{element:r,start:g,dispose:m,get chart(){return c}}}function ed(n,t=null){let e=t?`${Rn(t)}. ${n.text}`:n.text,i=D("div",{className:"chart",role:"img","aria-label":e}),s=D("ul",{className:"key"}),r=D("h2",{},`${Rn(n.title)} (${n.unit})`);return t&&r.append(D("small",{},t)),{element:D("figure",{},r,s,i,D("figcaption",{},n.text)),key:s,place:i}}function G0(n,t,e,i){let s=n.lines.map((r,o)=>[Float64Array.from(e[r.clip].time,a=>a-i.origins[r.clip]),t[o]]);return td(n)!==null?[s[0]?.[0]??[],...s.map(r=>r[1])]:rn.join(s)}function gT(n,t,e,i,s){let r=Ah(),o=(a,l,c)=>yT(n,...t?pT(t,e,i.span):[l,c]);return{width:s,height:wh,legend:{show:!1},cursor:{show:!1},padding:[8,10,0,0],scales:{x:{time:!1,auto:!1,distr:100,fwd:i.shareAt,bwd:i.momentAt},y:{range:o}},series:[{},...nd(n.lines)],axes:[{...r,...id,labelFont:r.font,label:()=>`${i.span.label} (${La(i.span).unit})${i.stretched?", stretched":""}`,filter:(a,l)=>l,splits:(a,l,c,h,u)=>i.stretched?_T(a,i):xT(c,h,u),values:(a,l)=>l.map(c=>c===null?"":H0(c*La(i.span).factor)),space:56},sd(n)],hooks:{drawClear:[a=>vT(a,e,td(n),i.span)],draw:[a=>bT(a,e,td(n),i.span)]}}}function _T(n,t){let e=Math.max(2,Math.floor(n.bbox.width/devicePixelRatio/uT)),{factor:i}=La(t.span),s=new Set;for(let r=0;r<=e;r++){let o=t.momentAt(r/e),a=[1,2,3,4,5,6].map(c=>Number((i*o).toPrecision(c))/i),l=c=>Math.abs(t.shareAt(c)-r/e)<.2/e;s.add(a.find(l)??a[a.length-1])}return[...s].filter(r=>r>=t.span.start&&r<=t.span.end)}function xT(n,t,e){let i=Math.ceil(n/e-1e-9);return Array.from({length:Math.floor(t/e+1e-9)-i+1},(s,r)=>(i+r)*e)}function nd(n){return n.map((t,e)=>({stroke:()=>_s(e).colour,dash:_s(e).dash,width:1.6,points:{show:!1},spanGaps:!0}))}var id={size:24,gap:3,labelSize:18,labelGap:0};function Ah(){return{stroke:()=>Fe("--muted"),grid:{stroke:()=>Fe("--grid"),width:1},ticks:{stroke:()=>Fe("--grid"),width:1,size:4},font:"12px system-ui, sans-serif"}}function sd(n){return{...Ah(),size:(t,e)=>Math.max(48,16+7*Math.max(0,...(e??[]).map(i=>i.length))),gap:3,values:(t,e)=>e.map(i=>i===null?"":H0(i)),...n.unit==="deg"?{incrs:fT,space:26}:{space:30}}}function yT(n,t,e){let[i,s]=[Math.min(0,t??0),Math.max(0,e??0)],r=.06*(s-i||1);return[n.unit==="deg"||i<0?i-r:i,s+2*r]}function H0(n){let t=Math.abs(n)<1e-12?"0":String(Number(n.toPrecision(6)));return t.length>7?Te(n):t.replace("-","−")}function vT(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n;s.save(),s.fillStyle=Fe("--band");for(let o of t[e].stages.filter(a=>a.driven)){let[a,l]=[o.start,o.end].map(h=>n.valToPos(h-i.origins[e],"x",!0)),c=Math.max(a,r.left);s.fillRect(c,r.top,Math.max(0,Math.min(l,r.left+r.width)-c),r.height)}s.restore()}function bT(n,t,e,i){if(e===null)return;let{ctx:s,bbox:r}=n,o=devicePixelRatio;s.save(),s.strokeStyle=Fe("--muted"),s.font=`bold ${12*o}px system-ui, sans-serif`,s.setLineDash([2*o,3*o]);for(let a of t[e].marks){let l=n.valToPos(a.time-i.origins[e],"x",!0);if(l<r.left-1||l>r.left+r.width+1)continue;s.beginPath(),s.moveTo(l,r.top),s.lineTo(l,r.top+r.height),s.stroke();let c=l>r.left+r.width-16*o?-1:1;s.fillStyle=Fe("--page"),s.fillRect(l+(c>0?2:-14)*o,r.top+1*o,12*o,15*o),s.fillStyle=Fe("--ink"),s.textAlign="center",s.fillText(a.letter,l+c*8*o,r.top+13*o)}s.restore()}function ST(n,t){let e=i=>{t.pause(),t.seek(n.posToVal(i.clientX-n.over.getBoundingClientRect().left,"x"))};n.over.addEventListener("pointerdown",i=>{i.button===0&&(n.over.setPointerCapture(i.pointerId),e(i))}),n.over.addEventListener("pointermove",i=>{n.over.hasPointerCapture(i.pointerId)&&e(i)})}function MT(n,t){return Array.from({length:t-n},(e,i)=>[1,2,5].map(s=>s*10**(n+i))).flat()}function Th(n,t){if(matchMedia("(prefers-reduced-motion: reduce)").matches)return;let e=new IntersectionObserver(i=>{i.some(s=>s.isIntersecting)&&(e.disconnect(),t.play())},{threshold:.3});e.observe(n.querySelector(".picture")??n),n.addEventListener("pointerdown",()=>e.disconnect(),{once:!0})}function W0(n){let t=n.clips.map(xi),e=ys(t,n.spans),i=mo(document.getElementById("player"),t,e,n);i.stage&&rd(i.stage.cells,t,e,n.energy);let s=Co(document.getElementById("plots"),n.plots,t,e);return Th(document.getElementById("player"),e),{clips:t,clock:e,player:i,plots:s}}function rd(n,t,e,i){let s=t.map((r,o)=>{let a=D("span",{className:"state-now"}),l=D("b",{},tr(_s(o)),r.name);return Xs(()=>l.replaceChild(tr(_s(o)),l.firstChild)),n[o].append(l,a),a});e.onChange(()=>{for(let[r,o]of t.entries()){let a=e.clipTime(r),c=[e.time+e.span.origins[r]>o.end?"ended":o.stageAt(a).name],[h]=o.readings;h&&c.push(wT(o.valuesAt(h.name,a),h.unit));let u=o.valuesAt(xs,a).reduce((f,d)=>f+d,0);o.tendons&&c.push(`${Te(i.factor*u)} ${i.unit}`),s[r].textContent=c.join(" · ")}})}function wT(n,t){let e=s=>t==="deg"?`${Nn(s,0)}°`:`${Te(s)} ${t}`,i=[Math.min(...n),Math.max(...n)].map(e);return i[0]===i[1]?i[0]:i.join(" to ")}var AT=[.1,.2,.5,1,2,5,10,15,30,45,60,90,180],TT=1.35;function Wa(n,t,e=[],i=null,s=null){let r=t.map(o=>ET(o,e[0],i,s));n.replaceChildren(...r.map(o=>o.element)),n.classList.add("plots");for(let o of r)o.start();return r}function ET(n,t,e,i){let[s,r,o]=[n.lines,n.balls,n.marks].map(M=>M.map(CT)),{element:a,key:l,place:c}=ed(n),h=(r.length?r:[s[0]]).map(M=>D("span",{className:"ball"},r.length&&M.name.length<3?M.name:"")),u=r.map(M=>[M.places[0],M.values[0]]),f=Math.round(TT*wh),d=RT(s),p=d,x=null;function g(){let M=s.map((T,I)=>D("li",{},tr(_s(I)),T.name)),y=r.length?"the run now":"moved by the slider";l.replaceChildren(...M,D("li",{},D("span",{className:"ball still"}),y))}function m(){for(let[M,[y,T]]of u.entries()){let[I,P]=[x.valToPos(y,"x"),x.valToPos(T,"y")];h[M].style.transform=`translate(${I.toFixed(2)}px, ${P.toFixed(2)}px)`}}function _(){let[M,y]=Zi(t.time,e.clipTime(0));for(let[T,{places:I,values:P}]of r.entries())u[T]=[od(I,M,y),od(P,M,y)];m()}function w(M){p=M,x.setScale("x",{min:M[0],max:M[1]})}function b(M,y,T){if(p!==d){let{places:R,values:F}=s[0],z=F.filter((q,H)=>R[H]>=p[0]&&R[H]<=p[1]),[U,G]=[Math.min(...z),Math.max(...z)];return[U-.25*(G-U),G+.25*(G-U)]}let I=r.reduce((R,F)=>Math.max(R,F.most),T),P=Math.min(0,y);return[P-.06*(I-P||1),I+.1*(I-P||1)]}function S(){let M=rn.join(s.map(y=>[y.sorted.places,y.sorted.values]));x=new rn(PT({data:n,lines:s,balls:r,marks:o,energyRange:b},c.clientWidth,f),M,c),x.over.append(...h),new ResizeObserver(()=>x.setSize({width:c.clientWidth,height:f})).observe(c),x.hooks.setSize=[m],x.hooks.setScale=[m],g(),Xs(()=>{g(),x.redraw(!1)}),n.top&&c.after(NT(d,n.top,w)),r.length?(e.onChange(_),DT(x,r,t,e)):UT(n,s[0],c,(y,T)=>{u[0]=[y,T],m()},i),w(d)}return{element:a,start:S,now:u,get chart(){return x}}}function CT({name:n,places:t,values:e}){let i={name:n,places:tn(t,Float32Array),values:tn(e,Float32Array)},s=Array.from(i.places.keys()).sort((r,o)=>i.places[r]-i.places[o]);return i.most=i.values.reduce((r,o)=>Math.max(r,o),0),i.sorted={places:s.map(r=>i.places[r]),values:s.map(r=>i.values[r])},i}function od(n,t,e){let i=n[Math.min(t+1,n.length-1)];return n[t]+e*(i-n[t])}function RT(n){let t=n.flatMap(s=>[s.sorted.places[0],s.sorted.places.at(-1)]),[e,i]=[Math.min(...t),Math.max(...t)];return[e-.03*(i-e),i+.03*(i-e)]}function PT({data:n,lines:t,balls:e,marks:i,energyRange:s},r,o){let a=Ah(),l=sd(n);return{width:r,height:o,legend:{show:!1},cursor:{show:!1},pxAlign:0,padding:[10,12,0,0],scales:{x:{time:!1,auto:!1,dir:n.backwards?-1:1},y:{range:s}},series:[{},...nd(t)],axes:[{...a,...id,labelFont:a.font,label:`${n.axis} (deg)`,values:l.values,incrs:AT,space:44},l],hooks:{draw:[c=>IT(c,e),c=>LT(c,i)]}}}function IT(n,t){let{ctx:e,bbox:i}=n,s=1.6*devicePixelRatio;e.save(),e.globalAlpha=.55,e.fillStyle=Fe("--accent");for(let{places:r,values:o}of t)for(let a=0;a<r.length;a++){let[l,c]=[n.valToPos(r[a],"x",!0),n.valToPos(o[a],"y",!0)];l>i.left&&l<i.left+i.width&&c>i.top&&c<i.top+i.height&&e.fillRect(l-s/2,c-s/2,s,s)}e.restore()}function LT(n,t){let{ctx:e,bbox:i}=n,s=devicePixelRatio;e.save(),e.beginPath(),e.rect(i.left-6*s,i.top,i.width+12*s,i.height+6*s),e.clip(),e.setLineDash([]),e.font=`${12*s}px system-ui, sans-serif`;for(let{name:r,places:o,values:a}of t){let l=Array.from(o,d=>n.valToPos(d,"x",!0)),c=Array.from(a,d=>n.valToPos(d,"y",!0)),[h,u]=[l[l.length>>1],c[c.length>>1]];if(e.beginPath(),l.length===1)e.arc(h,u,4.5*s,0,2*Math.PI),e.fillStyle=Fe("--page"),e.fill(),e.strokeStyle=Fe("--ink"),e.lineWidth=1.4*s,e.stroke();else{e.globalAlpha=.35;for(let d of l.keys())e.lineTo(l[d],c[d]);e.strokeStyle=Fe("--line-2"),e.lineWidth=7*s,e.stroke(),e.globalAlpha=1}let f=l.length>1?0:h>i.left+i.width/2?-1:1;e.fillStyle=Fe("--ink"),e.textAlign=["right","center","left"][f+1],e.fillText(r,h+12*f*s,u-9*s)}e.restore()}function NT(n,t,e){let i=[["whole curve",n],["barrier close up",t]].map(([s,r],o)=>{let a=D("button",{type:"button","aria-pressed":String(o===0)},s);return a.addEventListener("click",()=>{for(let l of i)l.setAttribute("aria-pressed",String(l===a));e(r)}),a});return D("div",{className:"ranges",role:"group","aria-label":"part of the curve"},...i)}function DT(n,t,e,i){let s=r=>{let o=n.over.getBoundingClientRect(),[a,l]=[r.clientX-o.left,r.clientY-o.top],[c,h]=[0,1/0];for(let{places:u,values:f}of t)for(let d=0;d<u.length;d++){let p=Math.hypot(n.valToPos(u[d],"x")-a,n.valToPos(f[d],"y")-l);p<h&&([c,h]=[d,p])}i.pause(),i.seekClip(0,e.time[c])};n.over.addEventListener("pointerdown",r=>{r.button===0&&(n.over.setPointerCapture(r.pointerId),s(r))}),n.over.addEventListener("pointermove",r=>{n.over.hasPointerCapture(r.pointerId)&&s(r)})}function UT(n,t,e,i,s){let r=t.places.length-1,o=D("input",{type:"range",min:"0",max:String(r),value:"0"});o.setAttribute("aria-label",`${n.axis} along the curve`);let a=D("output",{"aria-live":"off"}),l=()=>{let f=Number(o.value);i(t.places[f],t.values[f]);let[d,p]=[Te(t.places[f]),`${Te(t.values[f])} ${n.unit}`];a.textContent=`${d}°, ${p}`,o.setAttribute("aria-valuetext",`${n.axis} ${d} degrees, energy ${p}`)},c=n.poses&&s?tn(n.poses,Float32Array):null,h=!1;o.addEventListener("input",()=>{l(),h=!0,c&&s.seek(OT(c,t.places[Number(o.value)]))}),c&&s.onChange(()=>{h||(o.value=String(FT(t.places,od(c,Math.floor(s.time),s.time%1))),l()),h=!1});let u=n.drawn?[D("p",{className:"note"},n.drawn)]:[];e.after(D("div",{className:"slide"},o,a),...u),l()}function OT(n,t){let e=n[n.length-1]>=n[0]?1:-1,i=n.findIndex(r=>e*r>=e*t);if(i<=0)return i===0?0:n.length-1;let s=n[i]-n[i-1];return i-1+(s?(t-n[i-1])/s:0)}function FT(n,t){return n.reduce((e,i,s)=>Math.abs(i-t)<Math.abs(n[e]-t)?s:e,0)}function X0(n){let t=new Set,e={start:n.start,end:n.end,origins:[0]},i=n.start,s=0;function r(){s||=requestAnimationFrame(()=>{s=0;for(let o of t)o()})}return{get time(){return i},span:e,clipTime:(o,a=i)=>Math.min(n.end,Math.max(n.start,a)),timeAt:o=>e.start+o*(e.end-e.start),wayAt:o=>(o-e.start)/(e.end-e.start||1),onChange(o){return t.add(o),r(),()=>t.delete(o)},seek(o){i=Math.min(e.end,Math.max(e.start,o)),r()}}}function q0(n){let t=document.getElementById("curves");if(!n.clips)return{curves:Wa(t,n.curves)};let e=n.clips.map(xi),i=X0(e[0]),s=sh(document.getElementById("player"),e,i,n);return{clips:e,clock:i,player:s,curves:Wa(t,n.curves,[],null,i)}}async function $0(n){let t=new Blob([tn(n,Uint8Array)]).stream(),e=await new Response(t.pipeThrough(new DecompressionStream("deflate"))).arrayBuffer();function i({kind:s,start:r,shape:o,low:a,step:l}){let c=o.reduce((f,d)=>f*d,1);if(s==="f4")return new Float32Array(e,r,c);if(s==="f8")return new Float64Array(e,r,c);let h=new(s==="u2"?Uint16Array:Uint32Array)(e,r,c),u=BT(h,...o);return a?Float32Array.from(u,(f,d)=>a[d%o[1]]+l[d%o[1]]*f):u}return i}function BT(n,t,e){let i=n.constructor,s=new i(1),r=new i(n.length);for(let o=0;o<e;o++){s[0]=0;for(let a=0;a<t;a++)s[0]+=n[o*t+a],r[a*e+o]=s[0]}return r}var kT="M7 4.5v15l12-7.5z",zT="M7 5h3.5v14H7zM13.5 5H17v14h-3.5z",Js=180/Math.PI,Eh=1,Y0=10,Z0=720;function j0(n,t,e,i){let[s,r]=[n.lowest,n.highest].map(p=>p*Js),o=WT(n),a=HT(n,s,r,o),l=D("button",{type:"button",className:"play"}),c=D("input",{type:"range",min:s,max:r,step:"any","aria-label":"hinge angle"});c.dataset.keys="own";let h=D("p",{className:"time"}),u=p=>{t.pause(),t.seek(i(Math.min(r,Math.max(s,p))/Js))},f=()=>t.playing?t.pause():t.play(),d=a.map(({angle:p,name:x})=>{let g=D("button",{type:"button"},D("b",{},J0(p)),` ${x}`);return g.addEventListener("click",()=>u(p)),g});return c.addEventListener("input",()=>u(Number(c.value))),GT(c,()=>e(t.time)*Js,u,f),l.addEventListener("click",f),t.onChange(()=>{let p=e(t.time)*Js;c.value=p,h.textContent=`${J0(p,1)}${K0(n,p)}`,c.setAttribute("aria-valuetext",`${Nn(p,1)} degrees${K0(n,p)}`);for(let[g,m]of a.entries())d[g].setAttribute("aria-pressed",String(Math.abs(m.angle-p)<.005));let x=t.playing?"pause":"play: fold from stop to stop";l.getAttribute("aria-label")!==x&&l.replaceChildren(Za(t.playing?zT:kT)),l.setAttribute("aria-label",x)}),D("div",{className:"transport"},D("div",{className:"line"},l,VT(c,s,r,o,a)),D("div",{className:"choices"},h,D("div",{className:"states"},...d)))}function VT(n,t,e,i,s){let r=D("div",{className:"bands","aria-hidden":"true"}),o=D("div",{className:"ticks","aria-hidden":"true"}),a=l=>`${100*l/(e-t)}%`;for(let[l,c]of i){let h=D("span",{className:"band"});Object.assign(h.style,{left:a(l-t),width:a(c-l)}),r.append(h)}for(let{angle:l,stop:c}of s){let h=D("span",{className:c?"tick stop":"tick"});h.style.left=a(l-t),o.append(h)}return D("div",{className:"track"},r,n,o)}function GT(n,t,e,i){let s={ArrowLeft:-Eh,ArrowDown:-Eh,ArrowRight:Eh,ArrowUp:Eh},r={PageDown:-Y0,PageUp:Y0,Home:-1/0,End:1/0};n.addEventListener("keydown",o=>{if(!(o.shiftKey||o.ctrlKey||o.metaKey||o.altKey)){if(o.key===" ")i();else if(o.key in s)e(Math.round(t()+s[o.key]));else if(o.key in r)e(t()+r[o.key]);else return;o.preventDefault()}})}var J0=(n,t=null)=>`${t===null?Nn(n,Number.isInteger(Number(n.toFixed(3)))?0:1):Nn(n,t)}°`;function HT(n,t,e,i){let s=a=>[...new Set(n.joints.map(l=>Number((l[a]*Js).toFixed(6))))],r=[...s("lower").map(a=>({angle:a,name:"stop of the fold",stop:!0})),...i.flatMap(([a,l])=>[a,l].map(c=>({angle:c,name:"all straps slack"}))),...t<0&&e>0?[{angle:0,name:"flat"}]:[],...s("upper").map(a=>({angle:a,name:e>0?"stop of the overbend":"stop, flat",stop:!0}))],o=a=>Math.abs(a-t)<1e-6||Math.abs(a-e)<1e-6;return r.filter(a=>a.stop||a.name==="flat"||!o(a.angle)).sort((a,l)=>a.angle-l.angle)}function WT(n){let t=a=>Q0(n,a).every(({longer:l})=>l<0),[e,i]=[n.lowest*Js,n.highest*Js],s=(a,l)=>{let c=t(a);for(let h=0;h<40;h++){let u=(a+l)/2;t(u)===c?a=u:l=u}return l},r=[];if(!n.straps.length)return r;let o=t(e)?null:e;for(let a=1;a<=Z0;a++){let[l,c]=[a-1,a].map(h=>e+(i-e)*h/Z0);t(l)!==t(c)&&(o===null?o=s(l,c):(r.push([o,s(l,c)]),o=null))}return o!==null&&r.push([o,i]),r}function Q0(n,t){let e=n.turn(n.anglesTogether(t/Js));return n.straps.flatMap(i=>n.strapStretches(i,e).map(s=>({longer:s,rest:i.rest})))}function K0(n,t){let e=Q0(n,t);if(!e.length)return"";let i=e.filter(({longer:a})=>a<0).length,s=Math.max(...e.map(({longer:a})=>a));if(i===e.length)return`, straps slack by ${Nn(-1e3*s,1)} mm or more`;let r=Math.max(...e.map(({longer:a,rest:l})=>a/l)),o=`stretched by up to ${Nn(1e3*s,1)} mm (${Nn(100*r,1)} %)`;return i?`, ${i} of ${e.length} straps slack, others ${o}`:`, straps ${o}`}function t_(n){let t=D("input",{type:"range",min:0,max:100,step:1,value:0});return t.dataset.keys="own",t.addEventListener("input",()=>n(Number(t.value)/100)),t.setAttribute("aria-valuetext","together"),t.addEventListener("input",()=>{t.setAttribute("aria-valuetext",t.value==="0"?"together":`${t.value} % apart`)}),D("label",{className:"slide"},"take apart ",t)}function e_(n,t,e){let i=n.map((s,r)=>{let o=D("input",{type:"checkbox",checked:!0});o.dataset.keys="own",o.addEventListener("change",()=>e(r,o.checked));let a=D("span",{className:"swatch panel","aria-hidden":"true"});return a.style.background=s.colour,D("label",{},o,a,`${s.name}${t[r]>1?`, ${t[r]}`:""}`)});return D("fieldset",{className:"kinds"},D("legend",{},"show"),...i)}function ad(n,t,e){let i=D("select",{},...t.map((s,r)=>D("option",{value:String(r)},s)));return i.addEventListener("change",()=>e(Number(i.value))),D("label",{},`${n} `,i)}var Ch=28,n_=24;function i_(n,t){return n.ends.map(e=>{let[i,s]=e.map((r,o)=>new W(...r).applyMatrix4(Ro(t,n.bodies[o])));return i.distanceTo(s)-n.rest})}var XT=new pe,Ro=(n,t)=>t<0?XT:n[t];function ld(n,t,e,i,s){let r=new W(...n.axis).transformDirection(Ro(t,n.bodies[0])),o=new W(...n.up).transformDirection(Ro(t,n.bodies[0]));return n.ends.map(a=>{let l=a.map((_,w)=>new W(..._).applyMatrix4(Ro(t,n.bodies[w])).add(i)),c=l[1].clone().sub(l[0]),h=c.dot(r);c.addScaledVector(r,-h);let u=c.length(),f=u>1e-9?c.divideScalar(u):new W().crossVectors(r,o),d=new W().crossVectors(r,f).multiplyScalar(e),x=n.rest>Math.hypot(u,h)?Math.sqrt(n.rest**2-h**2):u,g=qT(s,x>1e-9?u/x:1);return{points:g.map(([_,w],b)=>l[0].clone().addScaledVector(f,_*x).addScaledVector(d,w*x).addScaledVector(r,h*b/(g.length-1))),wide:r,ends:l}})}function qT({values:n,shape:t},e){let[i,s]=t,r=Math.sqrt(Math.max(0,1-e))*(i-1),o=Math.min(i-2,Math.floor(r)),a=Math.min(1,r-o),l=(f,d,p)=>n[(f*s+d)*2+p],c=(f,d)=>l(o,f,d)+a*(l(o+1,f,d)-l(o,f,d)),h=c(s-1,0),u=h>1e-6?e/h:1;return Array.from({length:s},(f,d)=>[u*c(d,0),c(d,1)])}function s_(n,t,e){let i={triangles:[],edges:[]};for(let{points:s,wide:r,ends:o}of t){let a=r.clone().multiplyScalar(n.width/2),l=s.map((c,h)=>{let f=s[Math.min(h+1,s.length-1)].clone().sub(s[Math.max(h-1,0)]).cross(r).setLength(n.thickness/2);return[[-1,-1],[1,-1],[1,1],[-1,1]].map(([d,p])=>c.clone().addScaledVector(a,d).addScaledVector(f,p))});o_(i,l,[0,1,2,3]);for(let[c,h]of o.entries()){let u=new W(...n.across[c]).transformDirection(Ro(e,n.bodies[c]));YT(i,h,u,n.width,n.eye/2,n.peg/2)}}return i}function cd(n,t,e){let i=n.places.map(x=>new W(...x).add(e)),[s,r,o,a]=i,l=Ro(t,n.body),[c,h]=[o,a].map(x=>x.clone().sub(e).applyMatrix4(l).add(e)),u=r.clone().sub(s).normalize(),f=h.clone().sub(c).normalize(),d=r.distanceTo(o),p=[s];for(let x=0;x<=n_;x++)p.push($T(r,u,c,f,d,x/n_));return[...p,h]}function $T(n,t,e,i,s,r){let[o,a]=[1-r,r];return n.clone().multiplyScalar(o*o*(1+2*a)).addScaledVector(e,a*a*(1+2*o)).addScaledVector(t,s*o*o*a).addScaledVector(i,-s*a*a*o)}function r_(n,t){let e={triangles:[],edges:[]},i=n[1].clone().sub(n[0]).normalize(),s=new W(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0),r=n.map((o,a)=>{let l=n[Math.min(a+1,n.length-1)].clone().sub(n[Math.max(a-1,0)]).normalize();s=s.clone().addScaledVector(l,-s.dot(l)).normalize();let c=new W().crossVectors(l,s);return Array.from({length:Ch},(h,u)=>{let f=2*Math.PI*u/Ch;return o.clone().addScaledVector(s,Math.cos(f)*t/2).addScaledVector(c,Math.sin(f)*t/2)})});return o_(e,r,[]),e}function o_({triangles:n,edges:t},e,i){let s=e[0].length;for(let r=1;r<e.length;r++){let[o,a]=[e[r-1],e[r]];for(let l=0;l<s;l++){let c=(l+1)%s;n.push(o[l],o[c],a[c],o[l],a[c],a[l]),i.includes(l)&&t.push(o[l],a[l])}}for(let r of[e[0],e.at(-1)])for(let o=1;o<s-1;o++)n.push(r[0],r[o],r[o+1])}function YT({triangles:n,edges:t},e,i,s,r,o){let a=new W(Math.abs(i.z)<.9?0:1,0,Math.abs(i.z)<.9?1:0);a.addScaledVector(i,-a.dot(i)).normalize();let l=new W().crossVectors(i,a),c=(h,u,f)=>e.clone().addScaledVector(i,f*s/2).addScaledVector(a,u*Math.cos(h)).addScaledVector(l,u*Math.sin(h));for(let h=0;h<Ch;h++){let[u,f]=[h,h+1].map(p=>2*Math.PI*p/Ch),d=(p,x,g,m)=>n.push(p,x,g,p,g,m);d(c(u,r,-1),c(f,r,-1),c(f,r,1),c(u,r,1));for(let p of[-1,1])d(c(u,o,p),c(f,o,p),c(f,r,p),c(u,r,p)),t.push(c(u,r,p),c(f,r,p))}}function a_(n,t){let e=t.map(({origin:a,axis:l})=>[new W(...a),new W(...l)]),i=n.map((a,l)=>t.flatMap((c,h)=>c.body===l?[h]:[])),s=n.map(()=>new pe),r=new pe,o=new W;return function(l){for(let[c,h]of n.entries()){let u=s[c];h<0?u.identity():u.copy(s[h]);for(let f of i[c]){let[d,p]=e[f];r.makeRotationAxis(p,l[f]-t[f].built),o.copy(d).applyMatrix4(r),r.setPosition(d.x-o.x,d.y-o.y,d.z-o.z),u.multiply(r)}}return s}}var ZT=[-1,0,1].flatMap(n=>[-1,0,1].flatMap(t=>[-1,0,1].map(e=>[n,t,e]))),JT=new pe;function l_(n,t){let e=n.parts.map(d=>({...d,...d.mesh?KT(d.mesh,t):{}})),i={values:t(n.bows),shape:n.bows.shape},s=a_(n.bodies,n.turns),r=Math.min(...n.joints.map(d=>d.lower)),o=Math.max(...n.joints.map(d=>d.upper)),a=new Float64Array(n.turns.length);function l(d){for(let[p,x]of n.turns.entries())a[p]=x.built;for(let p of n.joints)a[p.turn]=Math.min(p.upper,Math.max(p.lower,d));return a}let c=(d,p)=>new W(...d.apart).multiplyScalar(p);function h(d,p,x,g=new pe){let m=c(d,x);return g.copy(d.body===null||d.body<0?JT:p[d.body]).multiply(new pe().makeTranslation(m.x,m.y,m.z))}function u(d,p,{apart:x,side:g}){let m=c(d,x);return d.root?r_(cd(d.root,p,m),d.root.diameter):s_(d.strap,ld(d.strap,p,g,m,i),p)}function f(d,p,{apart:x,side:g}){let m=[];for(let _ of d){if(_.outer){let S=h(_,p,x);for(let M of _.outer)m.push(...M.clone().applyMatrix4(S).toArray());continue}let w=c(_,x),b=_.root?[cd(_.root,p,w)]:ld(_.strap,p,g,w,i).map(S=>S.points);for(let S of b)for(let M=0;M<S.length;M+=4)m.push(...S[M].toArray())}return Float64Array.from(m)}return{parts:e,looks:n.looks,joints:n.joints,turns:n.turns,lowest:r,highest:o,turn:s,anglesTogether:l,matrixOf:h,bentMesh:u,outline:f,straps:e.filter(d=>d.strap).map(d=>d.strap),strapStretches:i_}}function KT({points:n,triangles:t,stops:e,edges:i},s){let r=s(n),o=s(t),a=n.shape[0];for(let l=0;l<o.length;l+=3)o[l+1]=(o[l]+o[l+1])%a,o[l+2]=(o[l]+o[l+2])%a;return{places:r,corners:o,stops:e,edges:s(i),outer:jT(r)}}function jT(n){let t=new Set;for(let[e,i,s]of ZT){let[r,o]=[0,-1/0];for(let a=0;a<n.length;a+=3){let l=e*n[a]+i*n[a+1]+s*n[a+2];l>o&&([r,o]=[a,l])}t.add(r)}return Array.from(t,e=>new W().fromArray(n,e))}function c_(n,t){let e=t(n.time),i=t(n.angles),[,s]=n.angles.shape,r=new Float64Array(s);function o(a){let[l,c]=Zi(e,a),h=Math.min(l+1,e.length-1);for(let u=0;u<s;u++){let f=i[l*s+u];r[u]=f+c*(i[h*s+u]-f)}return r}return{time:e,anglesAt:o,marks:n.marks,stages:n.stages,spans:n.spans}}var QT="#14171a",tE=.55,eE=Math.cos(Math.PI/9),nE=.42;function h_(n,t,e,i){let s=n.parts.map(d=>iE(d,n.looks[d.look].colour,i)),r=new Fn;for(let d of s)r.add(d.mesh,d.lines);let o=new Fn,a=n.turn(n.anglesTogether(0));function l(d){a=n.turn(e(d));for(let[p,x]of n.parts.entries()){let{mesh:g,lines:m}=s[p],_=!t.hidden.has(x.look);for(let w of[g,m])w.visible=_;_&&(x.places?n.matrixOf(x,a,t.apart,g.matrix):oE(s[p],n.bentMesh(x,a,t)))}}function c(){let d=new Qt(Fe("--accent"));for(let[p,{mesh:x}]of s.entries())for(let g of[x.material].flat())g.emissive.copy(d),g.emissiveIntensity=t.chosen===p?nE:0}function h(d,p){let x=new ma;x.setFromCamera(d,p),r.updateMatrixWorld(!0);for(let{mesh:m}of s)m.geometry.boundingSphere===null&&m.geometry.computeBoundingSphere();let[g]=x.intersectObjects(s.map(m=>m.mesh).filter(m=>m.visible),!1);return g?s.findIndex(m=>m.mesh===g.object):null}function u(d){let p=n.parts.findIndex(_=>_.name===d),{mesh:x}=s[p],g=x.geometry.getAttribute("position"),m=new sn(g.array.slice(),3);return Array.from(m.applyMatrix4(x.matrix).array)}function f(){for(let{mesh:d,lines:p}of s){d.geometry.dispose(),p.geometry.dispose();for(let x of[d.material,p.material].flat())x.dispose()}}return{group:r,shadow:o,pose:l,paint:c,sort:()=>{},at:h,verticesOf:u,dispose:f,current:()=>a}}function iE(n,t,e){let i=(h,u)=>new ds({color:h,side:Bn,flatShading:u,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),s=n.places?sE(n):new gn,r=n.places?[i(e,!1),i(t,!1)]:i(t,!0),o=new Ln(s,r),a=new gn;n.places&&a.setAttribute("position",new sn(u_(n.places,n.edges),3));let l=new Fs({color:QT,transparent:!0,opacity:tE}),c=new or(a,l);for(let h of[o,c])Object.assign(h,{frustumCulled:!1,matrixAutoUpdate:!1});return c.matrix=o.matrix,{mesh:o,lines:c}}function sE({places:n,corners:t,stops:e}){let i=new gn;return i.setAttribute("position",new sn(u_(n,t),3)),i.setAttribute("normal",new sn(rE(n,t),3)),i.addGroup(0,3*e,0),i.addGroup(3*e,t.length-3*e,1),i}function u_(n,t){let e=new Float32Array(3*t.length);for(let[i,s]of t.entries())for(let r=0;r<3;r++)e[3*i+r]=n[3*s+r];return e}function rE(n,t){let e=t.length/3,i=new Float64Array(t.length),s=Array.from({length:n.length/3},()=>[]);for(let l=0;l<e;l++){let[c,h,u]=[0,1,2].map(d=>3*t[3*l+d]),f=(d,p,x)=>n[p+x%3]-n[d+x%3];for(let d=0;d<3;d++)i[3*l+d]=f(c,h,d+1)*f(c,u,d+2)-f(c,h,d+2)*f(c,u,d+1);for(let d=0;d<3;d++)s[t[3*l+d]].push(l)}let r=Float64Array.from({length:e},(l,c)=>Math.hypot(...i.subarray(3*c,3*c+3))),o=new Float32Array(3*t.length),a=(l,c)=>i[3*l]*i[3*c]+i[3*l+1]*i[3*c+1]+i[3*l+2]*i[3*c+2];for(let l=0;l<t.length;l++){let c=Math.floor(l/3),h=[0,0,0];for(let f of s[t[l]])if(f===c||a(c,f)>=eE*r[c]*r[f])for(let d=0;d<3;d++)h[d]+=i[3*f+d];let u=Math.hypot(...h)||1;for(let f=0;f<3;f++)o[3*l+f]=h[f]/u}return o}function oE({mesh:n,lines:t},{triangles:e,edges:i}){for(let[s,r]of[[n,e],[t,i]]){let{geometry:o}=s,a=o.getAttribute("position");a?.count!==r.length&&(a=new sn(new Float32Array(3*r.length),3),o.setAttribute("position",a));for(let[l,c]of r.entries())c.toArray(a.array,3*l);a.needsUpdate=!0,o.boundingSphere=null}}var aE=.25,f_=60,lE=4;async function p_(n){let t=await $0(n.arrays),e=l_(n,t),i={apart:0,side:1,hidden:new Set,chosen:null},s=[cE(e,i),...n.motion?[hE(e,i,c_(n.motion,t))]:[]],r=uE(s),o=document.getElementById("player"),a=fE(o,n,e,i,r),l=xE(e,n,i,a);return a.onPress(l.choose),{model:e,state:i,clock:s[0].clock,run:s[1]?.clock??null,...a,choose:l.choose}}function cE(n,t){let e=c=>n.highest+c*(n.lowest-n.highest),i=c=>(c-n.highest)/(n.lowest-n.highest||1),s=Float64Array.from({length:f_+1},(c,h)=>h/f_),r=c=>n.anglesTogether(e(c)),o=m_(n,t,{time:s,anglesAt:r,marks:[],stages:[]}),a=ys([g_(n,o,r)],[{name:"",label:"",start:0,end:1,origins:[0],whole:!1}]);a.setSpeed(aE);let l=j0(n,a,e,i);return{name:"all joints alike",clip:o,clock:a,anglesAt:r,control:l}}function hE(n,t,e){let i=m_(n,t,e),s=ys([g_(n,i,e.anglesAt)],e.spans);return{name:"as in the simulated run",clip:i,clock:s,anglesAt:e.anglesAt,control:nh([i],s)}}function m_(n,t,{time:e,anglesAt:i,marks:s,stages:r}){let o=()=>{let a=n.parts.filter(l=>!t.hidden.has(l.look));return a.length?a:n.parts};return{name:"",time:e,start:e[0],end:e[e.length-1],marks:s,stages:r,readings:[],reach:0,mesh:{tubes:[],joints:[],jointRadius:0},pointsAt:a=>n.outline(o(),n.turn(i(a)),t),stageAt:a=>r.findLast(l=>l.start<=a)??r[0],markAt:a=>s.find(l=>Math.abs(l.time-a)<1e-9)}}function g_(n,t,e){let i=n.parts.filter(s=>s.outer).map(s=>({...s,outer:[s.outer[0],s.outer.at(-1)]}));return{...t,pointsAt:s=>n.outline(i,n.turn(e(s)),{apart:0,side:1})}}function uE(n){let t=n[0],e={of:null},i=new Set;for(let a of n)a.clock.onChange(()=>{if(a===t)for(let l of i)l()});let s=()=>t.clock.redraw(),r={get time(){return t.clock.time},get playing(){return t.clock.playing},get span(){return e.of!==t.clock.span&&(e={...t.clock.span,of:t.clock.span}),e},clipTime:(a,l)=>t.clock.clipTime(a,l),timeAt:a=>t.clock.timeAt(a),wayAt:a=>t.clock.wayAt(a),onChange(a){return i.add(a),s(),()=>i.delete(a)},seek:a=>t.clock.seek(a),seekClip:(a,l)=>t.clock.seekClip(a,l),step:a=>t.clock.step(a),play:()=>t.clock.play(),pause:()=>t.clock.pause()};return{clip:{...n[0].clip,pointsAt:a=>t.clip.pointsAt(a)},clock:r,sources:n,get now(){return t},anglesAt:a=>t.anglesAt(a),take(a){t.clock.pause(),t=n[a],e={of:null},s()},changed(){e={of:null},s()}}}var __="Press a part, or its name in the table, to see what it is.",d_="parts";function fE(n,t,e,i,s){let{clip:r,clock:o,sources:a}=s,l=null,h=Ua([r],o,()=>l=h_(e,i,s.anglesAt,t.stopColour),t.text),u=h?D("div",{className:"picture"},h.element,oh(h.eye,null)):D("p",{className:"note"},rh(d_)),f=D("p",{className:"chosen",role:"status"},__),d=D("div",{},a[0].control);return n.replaceChildren(u,f,d,dE(e,i,s,d),pE(e,i,s),mE(t,e,h),th([r],h!==null,d_)),n.classList.add("player"),n.setAttribute("role","region"),n.setAttribute("aria-label","the parts moving"),eh(n,[r],o,h?.eye,dr[0]),{stage:h,shape:l,info:f,repaint:()=>{l?.paint(),o.seek(o.time)},onPress:p=>h&&_E(h.canvas,x=>p(l.at(x,h.eye.camera)))}}function dE(n,t,e,i){let s=l=>{Object.assign(t,l),e.changed()},r=e.sources.map(l=>l.name),o=ad("motion",r,l=>{e.take(l),i.replaceChildren(e.now.control)}),a=ad("slack straps bow",["away from the hinge","towards the hinge"],l=>s({side:l?-1:1}));return D("div",{className:"choices"},...r.length>1?[o]:[],t_(l=>s({apart:l})),...n.straps.length?[a]:[])}function pE(n,t,e){let i=n.looks.map((s,r)=>n.parts.reduce((o,a)=>o+(a.look===r?a.count:0),0));return e_(n.looks,i,(s,r)=>{r?t.hidden.delete(s):t.hidden.add(s),e.changed()})}function mE(n,t,e){let i=D("span",{className:"swatch taut","aria-hidden":"true"});return D("ul",{className:"legend"},...t.parts.some(s=>s.stops)?[gE(n.stopColour,"face of a stop")]:[],...t.straps.length?[D("li",{},i,"on the slider: where straps are taut")]:[],...e?[D("li",{},`squares of the grid: ${Te(1e3*Da(e.eye.size))} mm`)]:[])}function gE(n,t){let e=D("span",{className:"swatch panel","aria-hidden":"true"});return e.style.background=n,D("li",{},e,t)}function _E(n,t){let e=null;n.addEventListener("pointerdown",i=>{e=i.isPrimary?[i.clientX,i.clientY]:null}),n.addEventListener("pointerup",i=>{if(e===null||Math.hypot(i.clientX-e[0],i.clientY-e[1])>lE)return;let s=n.getBoundingClientRect(),[r,o]=[(i.clientX-s.left)/s.width,(i.clientY-s.top)/s.height];t(new Yt(2*r-1,1-2*o))})}function xE(n,t,e,i){let r=Array.from(document.querySelectorAll("#bill tbody tr")).map((l,c)=>{let[h]=l.querySelector("th").childNodes,u=D("button",{type:"button",className:"name","aria-pressed":"false"},h.textContent);return h.replaceWith(u),u.addEventListener("click",()=>o(e.chosen===c?null:c)),u});function o(l){e.chosen=l;for(let[c,h]of r.entries())h.setAttribute("aria-pressed",String(c===l));i.info.textContent=l===null?__:a(l),i.repaint()}function a(l){let c=n.parts[l],[h,u,f]=c.facts,d=c.count>1?`${c.count} alike, each `:"";return`${c.name}: ${n.looks[c.look].name} of ${h}, ${d}${u}, ${f}`}return{choose:o}}function x_(n){let t=n.clips.map(xi),e=ys(t,n.spans),i=mo(document.getElementById("player"),t,e,n),s=n.curves?Wa(document.getElementById("curves"),n.curves,t,e):[],r=Co(document.getElementById("plots"),n.plots,t,e);go(document.getElementById("readout"),t[0],e,n.energy),Th(document.getElementById("player"),e);let o=lh(document.getElementById("try"),t[0],n,()=>e.pause());return{clips:t,clock:e,player:i,curves:s,plots:r,trial:o}}function Rh(n){return n.energy?po:Im}function y_(n,t){let e=n.at(t).map(s=>Math.round(255*s)),i=.299*e[0]+.587*e[1]+.114*e[2]>118;return{face:`rgb(${e.join(" ")})`,ink:i?"#000":"#fff"}}var yE={"●":"opened","◆":"folded","■":"closed","×":"unfolded","✱":"stuck","↺":"returned","↻":"reclosed","▷":"moving","◁":"opening","≠":"untrusted","✚":"diverged","⊘":"unbuilt","–":"untried","·":"unrun","⊗":"before"};function Ss(n){return`what ${yE[n]??"other"}`}var vE=["energy","time by torque"];function v_(n,t){let{factors:e,quantities:i,words:s}=n,r=e.map(u=>u.values.length),o=new Map;for(let u of t)o.set(u.point,[...o.get(u.point)??[],u]);function a(u){if(n.sampled)return e.map(()=>u);let f=[];for(let d=r.length-1;d>=0;d--)f[d]=u%r[d],u=Math.floor(u/r[d]);return f}let l=u=>u.reduce((f,d,p)=>f*r[p]+d,0);function c(u){let d=(vE.includes(u.group)?i.filter(_=>_.group===u.group):[u]).flatMap(_=>_.values??[]).filter(_=>_!==null);if(!d.length)return null;let[p,x]=[d.reduce((_,w)=>Math.min(_,w)),d.reduce((_,w)=>Math.max(_,w))],g=_=>x>p?(_-p)/(x-p):.5,m=bE((u.values??[]).filter(_=>_!==null));return{low:p,high:x,colour:_=>y_(Rh(u),g(_)),text:_=>Ph(Number(_.toFixed(m)))}}let h=(u,f)=>`${u.name} ${u.texts[f]}${u.unit?` ${u.unit}`:""}`;return{study:n,sizes:r,placesOf:a,pointAt:l,scaleOf:c,factorText:h,largestSpan:t.reduce((u,f)=>Math.max(u,f.play.clips[0].span_m),0),runsOf:u=>o.get(u)??[],word:u=>s[u],pointText:u=>a(u).map((f,d)=>h(e[d],f)).join(", "),valueText(u,f){let d=u.values?.[f]??null;return d===null?s[u.reasons[f]].word:`${Ph(d)} ${u.unit}`}}}function bE(n){let t=n.reduce((e,i)=>Math.max(e,Math.abs(i)),0);return Math.min(20,Math.max(0,2-Math.floor(Math.log10(t||1))))}function Ph(n){return String(Number(n.toPrecision(3))).replace("-","−")}var SE="http://www.w3.org/2000/svg",[b_,hd]=[600,420],Ih={left:64,right:14,top:12,bottom:52};function M_(n,t,e){let{factors:i,points:s}=n.study,{quantity:r}=t,o=Array.from({length:s},(p,x)=>x),a=n.scaleOf(r),l=S_(i[t.x].values,i[t.x],Ih.left,b_-Ih.right),c=t.y===null?r.values??o.map(()=>0):i[t.y].values,h=t.y===null?{name:r.title,unit:r.unit}:i[t.y],u=S_(c,h,hd-Ih.bottom,Ih.top),f=br("svg",{viewBox:`0 0 ${b_} ${hd}`,class:"scatter",role:"listbox","aria-label":`${r.title} of ${s} drawn points; arrows move between them, enter opens one`});f.append(...TE(l,u));let d=o.map(p=>ME(n,t,a,p,l.place(p),u.place(p)));return f.append(...d),(d[t.current??0]??d[0])?.setAttribute("tabindex","0"),wE(f,d,e),{element:D("div",{className:"scroll"},f),points:o}}function ME(n,t,e,i,s,r){let{quantity:o}=t,a=o.values?.[i]??null,l=`${n.pointText(i)}: ${n.valueText(o,i)}`,c=br("g",{role:"option",tabindex:"-1","aria-label":l,"aria-selected":String(t.opened===i),"data-point":i,transform:`translate(${s.toFixed(1)} ${r.toFixed(1)})`}),h=br("title",{});h.textContent=l,c.append(h);let u=a===null?n.word(o.reasons[i]).sign:"";if(u&&c.setAttribute("class",Ss(u)),c.append(br("circle",{r:8,class:a===null?"missing":"found",fill:a===null?"transparent":e.colour(a).face})),u){let f=br("text",{"text-anchor":"middle",dy:"0.36em"});f.textContent=u,c.append(f)}return c}function wE(n,t,e){let i=r=>r.target.closest("[data-point]");n.addEventListener("click",r=>{i(r)&&e(Number(i(r).dataset.point))});let s={ArrowLeft:-1,ArrowUp:-1,ArrowRight:1,ArrowDown:1};n.addEventListener("keydown",r=>{let o=i(r);if(!o||r.ctrlKey||r.metaKey||r.altKey)return;let a=Number(o.dataset.point);if(r.key==="Enter"||r.key===" ")e(a);else if(r.key in s)t[a+s[r.key]]&&(o.setAttribute("tabindex","-1"),t[a+s[r.key]].setAttribute("tabindex","0"),t[a+s[r.key]].focus());else return;r.preventDefault()})}function S_(n,t,e,i){let s=t.unit?`${t.name} (${t.unit})`:t.name,r=n.filter(d=>typeof d=="number"),o=[...new Set(n.filter(d=>typeof d=="string"))],a=o.length?d=>o.indexOf(d):d=>d,l=o.length?-.5:Math.min(...r),c=o.length?o.length-.5:Math.max(...r),h=.04*(i-e),u=d=>e+h+(a(d)-l)/(c-l||1)*(i-e-2*h),f=o.length?o:r.length?AE(l,c):[];return{label:s,from:e,to:i,ticks:f.map(d=>[u(d),typeof d=="number"?Ph(d):d]),place:d=>n[d]===null?e:u(n[d])}}function AE(n,t){if(!(t>n))return[n];let e=(t-n)/5,i=10**Math.floor(Math.log10(e)),s=i*([1,2,5].find(o=>o*i>=e)??10),r=[];for(let o=Math.ceil(n/s)*s;o<=t+1e-9*s;o+=s)r.push(Number(o.toPrecision(12)));return r}function TE(n,t){let e=[br("path",{class:"axis",d:`M${n.from} ${t.to}V${t.from}H${n.to}`})],i=(s,r)=>{let o=br("text",{class:"label",...r});o.textContent=s,e.push(o)};for(let[s,r]of n.ticks)i(r,{x:s,y:t.from+18,"text-anchor":"middle"});for(let[s,r]of t.ticks)i(r,{x:n.from-8,y:s,dy:"0.35em","text-anchor":"end"});return i(n.label,{x:(n.from+n.to)/2,y:hd-8,"text-anchor":"middle"}),i(t.label,{transform:`translate(14 ${(t.from+t.to)/2}) rotate(-90)`,"text-anchor":"middle"}),e}function br(n,t){let e=document.createElementNS(SE,n);for(let[i,s]of Object.entries(t))e.setAttribute(i,s);return e}var EE=2e4,CE=16,RE=16,w_={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function E_(n,t){let{quantities:e,sampled:i}=n.study,s=n.study.axes.filter(x=>n.sizes[x]>1),[r,o]=s.length>1?s:[null,s[0]??0],a={quantity:e[0],x:o,y:r,fixed:[...n.study.cuts],current:null,opened:null},l=D("div",{className:"map-place"}),c=D("div",{className:"map-legend"}),h=D("p",{className:"note"}),u=()=>{let x=i?M_(n,a,f):LE(n,a,f);l.replaceChildren(x.element),c.replaceChildren(...UE(n,a.quantity,x.points)),h.textContent=OE(n,a.quantity,x.points)},f=x=>{a.current=a.opened=x,PE(l,x),t(x,a.quantity)},d=IE(n,a,s,u),p=D("section",{className:"map"},D("h2",{},"Map"),d.element,l,c,h);return u(),{element:p,show(x){a.current=a.opened=x,i||(a.fixed=n.placesOf(x)),d.fill(),u()}}}function PE(n,t){for(let e of n.querySelectorAll("[data-point]")){let i=Number(e.dataset.point)===t;e.setAttribute("aria-selected",String(i)),e.tabIndex=i?0:-1}}function IE(n,t,e,i){let{factors:s,quantities:r,sampled:o}=n.study,a=D("div",{className:"choices"}),l=(u,f,d,p)=>{let x=D("select",{},...f.map(([g,m])=>D("option",{value:String(g)},m)));return x.value=String(d),x.addEventListener("change",()=>{p(Number(x.value)),h(),i(),[...a.querySelectorAll("label")].find(g=>g.dataset.name===u)?.querySelector("select").focus()}),D("label",{},`${u} `,x)},c=(u,f)=>d=>{t[f]===d&&(t[f]=t[u]),t[u]=d};function h(){let u=[l("show",r.map((f,d)=>[d,f.title]),r.indexOf(t.quantity),f=>{t.quantity=r[f]})];if(e.length>2){let f=e.map(d=>[d,s[d].name]);u.push(l("across",f,t.x,c("x","y")),l("upwards",f,t.y,c("y","x")))}for(let f of e.filter(d=>!o&&d!==t.x&&d!==t.y)){let d=s[f].texts.map((p,x)=>[x,s[f].unit?`${p} ${s[f].unit}`:p]);u.push(l(s[f].name,d,t.fixed[f],p=>{t.fixed[f]=p}))}for(let f of u)f.dataset.name=f.firstChild.textContent.trim();a.replaceChildren(...u)}return h(),{element:a,fill:h}}function LE(n,t,e){let{factors:i}=n.study,[s,r]=[n.sizes[t.x],t.y===null?1:n.sizes[t.y]];if(s*r>EE)return{element:D("p",{className:"note"},"This map has too many cells for a page; the study's figures have it."),points:[]};let o=n.scaleOf(t.quantity),a=s<=CE,l=(m,_)=>n.pointAt(t.fixed.map((w,b)=>b===t.x?m:b===t.y?_:w)),c=new Map,h=[],u=[];for(let m=r-1;m>=0;m--){let _=D("tr",{},D("th",{scope:"row"},t.y===null?"":T_(i[t.y],m)));for(let w=0;w<s;w++){let b=l(w,m),S=D("td",{tabIndex:-1,role:"gridcell"});NE(S,n,t,o,b,a),c.set(`${w} ${m}`,S),u.push(b),_.append(S)}h.push(_)}let f=i[t.x].texts.map((m,_)=>D("th",{scope:"col"},T_(i[t.x],_)));h.push(D("tr",{className:"feet"},D("td"),...f));let d=D("table",{role:"grid",className:a?"grid":"grid small","aria-label":BE(n,t)},D("tbody",{},...h));d.style.setProperty("--columns",s);let p=[...c.values()].find(m=>Number(m.dataset.point)===t.current)??c.get("0 0");p.tabIndex=0,DE(d,c,e);let x=D("div",{className:"upwards"},t.y===null?"":A_(i[t.y])),g=D("div",{className:"across"},A_(i[t.x]));return{element:D("div",{className:r<6?"axes low":"axes"},x,D("div",{},D("div",{className:"scroll"},d),g)),points:u}}function NE(n,t,e,i,s,r){let{quantity:o}=e,a=o.values?.[s]??null;n.dataset.point=s,n.setAttribute("aria-selected",String(e.opened===s));let l=`${t.pointText(s)}: ${o.values?`${o.title} `:""}${t.valueText(o,s)}`;if(n.setAttribute("aria-label",l),n.title=l,a===null){let{sign:u}=t.word(o.reasons[s]);n.className=Ss(u),n.append(D("span",{},r?u:""));return}let{face:c,ink:h}=i.colour(a);n.style.background=c,n.style.color=h,n.textContent=r?i.text(a):""}function DE(n,t,e){let i=new Map([...t].map(([s,r])=>[r,s.split(" ").map(Number)]));n.addEventListener("click",s=>{let r=s.target.closest("[data-point]");r&&e(Number(r.dataset.point))}),n.addEventListener("keydown",s=>{let r=s.target.closest("[data-point]");if(!r||s.ctrlKey||s.metaKey||s.altKey)return;let[o,a]=i.get(r),[l,c]=w_[s.key]??[0,0],h=Math.max(...[...i.values()].map(([f])=>f)),u={Home:`0 ${a}`,End:`${h} ${a}`}[s.key]??`${o+l} ${a+c}`;if(s.key==="Enter"||s.key===" ")e(Number(r.dataset.point));else{if(!(s.key in w_)&&s.key!=="Home"&&s.key!=="End")return;t.has(u)&&(r.tabIndex=-1,t.get(u).tabIndex=0,t.get(u).focus())}s.preventDefault()})}function UE(n,t,e){let i=[],s=n.scaleOf(t);if(s){let o=D("span",{className:"bar","aria-hidden":"true"});o.style.background=Rh(t).gradient,i.push(D("p",{className:"scale"},`${t.title} (${t.unit})`,D("span",{},s.text(s.low)),o,D("span",{},s.text(s.high))))}let r=[...C_(t,e)].map(([o,a])=>{let{word:l,sign:c}=n.word(o);return D("li",{},D("span",{className:Ss(c),"aria-hidden":"true"},D("span",{},c)),`${l} (${a})`)});return r.length&&i.push(D("ul",{},...r)),i}function C_(n,t){let e=new Map;for(let i of t){let s=n.reasons[i];s!==null&&e.set(s,(e.get(s)??0)+1)}return new Map([...e].sort(([i],[s])=>i-s))}function OE(n,t,e){let i=e.filter(c=>(t.values?.[c]??null)!==null),s=[...C_(t,e)].map(([c,h])=>`${h} ${n.word(c).word}`),r=`${t.title[0].toUpperCase()}${t.title.slice(1)}`;if(!i.length)return`${r} of ${e.length} points: ${s.join(", ")||"none"}.`;let o=s.length?` The others: ${s.join(", ")}.`:"",[a,l]=[Math.min,Math.max].map(c=>FE(n,t,i,c));return`${r}, known of ${i.length} of ${e.length} points: from ${a} to ${l}.${o}`}function FE(n,t,e,i){let s=e.map(a=>t.values[a]).reduce((a,l)=>i(a,l)),r=e.filter(a=>t.values[a]===s),o=r.length>1?`${r.length} points`:n.pointText(r[0]);return`${n.valueText(t,r[0])} (${o})`}function BE(n,t){let{factors:e}=n.study,i=t.y===null?e[t.x].name:`${e[t.x].name} across and ${e[t.y].name} upwards`;return`${t.quantity.title} over ${i}; arrows move between cells, enter opens one`}function A_(n){return n.unit?`${n.name} (${n.unit})`:n.name}function T_(n,t){let e=Math.ceil(n.texts.length/RE);return t%e?"":n.texts[t]}var R_=2;function L_(n){let t=document.getElementById("live")?.textContent??null,e=t&&JSON.parse(t),i=D("div",{className:"answer"}),s=D("p",{className:"outcome",role:"status"}),r=D("div"),o=D("div"),a=null,l=!1,c=0,h=0;function u(m,_){if(h+=1,c=m,!e)return[];if(!Jc())return _?[]:[D("p",{className:"note"},`Nor can it be simulated here: ${e.refused}.`)];if(a)p(m);else if(!l){let w=D("button",{type:"button",className:"try"},_?"Try it and refine here":"Simulate it here"),b=D("p",{className:"note"});w.addEventListener("click",()=>f(w,b)),o.replaceChildren(D("div",{className:"offer"},w,b))}return[o]}async function f(m,_){l=m.disabled=!0,_.textContent="Starting the simulator …";try{a=await ah(xi(e.bench.clips[0]),e.bench,t,Kc),o.replaceChildren(i),i.replaceChildren(a.element),a.begin(),p(c)}catch(w){_.textContent=`It cannot be simulated here: ${w.message}.`}}let d=m=>a.engine.ask({act:"answer",values:m,search:e.search});async function p(m){let _=++h,w=D("button",{type:"button"},"Refine here");w.addEventListener("click",()=>g(m)),r.replaceChildren(),i.replaceChildren(s,w,r,a.element),s.textContent="Simulating …",a.sliders.set(e.points[m]);let b=(await d(e.points[m])).answer;_===h&&(s.textContent=`${Rn(n.pointText(m))}: ${I_(e,b)}.`,x(m))}function x(m){a.sliders.set(e.points[m]),a.engine.tell({act:"restart",through:!1})}async function g(m){let _=++h,w=zE(n,e,m),b=new Map,S=D("p",{className:"note",role:"status"}),M=w[1].values.map(R=>w[0].values.map(F=>kE(w,F,R))).reverse(),y=M.map((R,F)=>D("tr",{},D("th",{scope:"row"},P_(w[1],w[1].values.length-1-F)),...R.map(({cell:z})=>z))),T=D("tr",{className:"feet"},D("td"),...w[0].values.map((R,F)=>D("th",{scope:"col"},P_(w[0],F)))),I=D("table",{className:"grid"},D("caption",{},VE(w)),D("tbody",{},...y,T));r.replaceChildren(D("div",{className:"table",tabIndex:0,role:"group","aria-label":"finer map"},I),S);let P=M.flat();for(let[R,{cell:F,values:z,where:U}]of P.entries()){S.textContent=`${R} of ${P.length} points simulated`;let G=(await d({...e.points[m],...z})).answer;if(_!==h)return;let q=n.study.words.find(({word:H})=>H===G.word)?.sign??"?";F.className=Ss(q),F.replaceChildren(D("span",{},q)),F.title=`${U}: ${I_(e,G)}`,F.setAttribute("aria-label",F.title),b.set(G.word,q)}S.textContent=[...b].map(([R,F])=>`${F} ${R}`).join(" · "),x(m)}return{offer:u,get panel(){return a}}}function kE(n,t,e){let i={[n[0].key]:t};n[1].key&&(i[n[1].key]=e);let s=n.filter(({key:r})=>r).map(r=>`${r.name} ${Te(r.factor*i[r.key])} ${r.unit}`).join(", ");return{cell:D("td",{"aria-label":`${s}: not simulated yet`}),values:i,where:s}}function zE(n,t,e){let i=n.study.axes.filter(a=>n.sizes[a]>1),[s,r]=i.length>1?i:[null,i[0]??0],o=a=>{if(a===null)return{key:"",name:"",unit:"",factor:1,values:[0]};let{key:l,name:c}=n.study.factors[a],h=t.knobs.find(g=>g.key===l),u=n.placesOf(e),f=g=>t.points[n.pointAt(u.map((m,_)=>_===a?g:m))][l],[d,p]=[Math.max(0,u[a]-1),Math.min(n.sizes[a]-1,u[a]+1)],x=[];for(let g=d;g<p;g++)for(let m=0;m<R_;m++)x.push(f(g)+m/R_*(f(g+1)-f(g)));return{key:l,name:c,unit:h.unit,factor:h.factor,values:[...x,f(p)]}};return[o(r),o(s)]}var P_=({key:n,factor:t,unit:e,values:i},s)=>n?`${Te(t*i[s])} ${e}`:"";function VE([n,t]){return t.key?`${Rn(n.name)} across, ${t.name} upwards, at half the steps`:`${Rn(n.name)}, at half the steps`}function I_(n,{status:t,least:e}){let s=(n.search?[n.search.first,n.search.second].filter(Boolean):[]).filter(({name:r})=>e[r]!==null&&e[r]!==void 0).map(({key:r,name:o,title:a})=>{let{factor:l,unit:c}=n.knobs.find(h=>h.key===r);return`${a} ${Te(l*e[o])} ${c}`});return[t,...s].join("; ")}var GE=["torque","time","work","energy"];function N_(n){let t=D("h2"),e=D("p",{className:"outcome",role:"status"}),i=D("table",{className:"numbers"}),s=D("section",{className:"facts",id:"point"},t,e,D("div",{className:"table"},i)),r=D("div",{className:"parts",role:"group","aria-label":"runs of this point"}),o=D("div"),a=D("div",{className:"more"}),l=D("section",{className:"run",id:"run","aria-label":"the run that is open"},r,o,a),c=L_(n),h={facts:s,element:l,point:null,playing:null,answers:c,open:d,show:g},u=null,f=Ia();function d(_,{play:w=!1,transition:b=null}={}){h.point=_;let S=n.runsOf(_);t.textContent=`Point ${_+1}`,e.textContent=`${Rn(n.pointText(_))}: ${n.study.statuses[_]}.`,i.replaceChildren(D("caption",{},"In the study’s table"),D("tbody",{},...$E(n,_))),r.replaceChildren(...S.length>1?S.map(p):S.map(M=>D("b",{},Rn(M.title)))),S.length?g((b===null?null:S.find(M=>M.transition===b))??S[0],{play:w}):(x(),o.replaceChildren(D("p",{className:"note"},YE(n,_)))),a.replaceChildren(...n.study.built[_]?c.offer(_,S.length>0):[])}function p(_){let w=D("button",{type:"button"},_.title);return w.dataset.part=_.part,w.addEventListener("click",()=>g(_,{play:!0})),w}function x(){h.playing?.dispose(),h.playing=null}function g(_,{play:w=!1}={}){x();for(let P of r.querySelectorAll("button"))P.setAttribute("aria-pressed",String(P.dataset.part===_.part));let b=u&&u!==_?u:null,S=b?[b,_]:[_],M={player:D("div"),plots:D("div"),readouts:S.map(()=>D("div"))},[y,T]=[ZE,JE].map(P=>S.map((R,F)=>P(R,D_(S)[F]))),I=_.advice?[D("p",{className:"note"},_.advice)]:[];o.replaceChildren(D("p",{},_.text),m(_),...I,M.player,M.plots,...M.readouts,...y,...T),f.scale=n.largestSpan/_.play.clips[0].span_m,h.playing={run:_,beside:b,...HE(M,_,b,n,f)},_o(o),w&&!matchMedia("(prefers-reduced-motion: reduce)").matches&&h.playing.clock.play()}function m(_){let b=D("button",{type:"button",className:"pin"},u?`unpin point ${u.point+1}`:"pin, to compare it with another");return b.addEventListener("click",()=>{u=u?null:_,g(_),o.querySelector(".pin").focus()}),b}return h}function HE(n,t,e,i,s){let r=e?[e,t]:[t],o=r.map((d,p)=>XE(d,D_(r)[p],i)),a=r.map((d,p)=>({...xi(d.play.clips[0]),...e?{name:o[p]}:{}})),l=ys(a,e?[qE(a)]:t.play.spans),c=r.map(d=>d.play.energy).reduce((d,p)=>p.largest_J>d.largest_J?p:d),h=e?`${Rn(a[0].name)} and ${a[1].name}, side by side on one clock.`:t.play.text,u=mo(n.player,a,l,{...t.play,energy:c,text:h},s);e&&u.stage&&rd(u.stage.cells,a,l,c);let f=Co(n.plots,e?WE(r,a):t.play.plots,a,l);n.plots.classList.toggle("paired",e!==null);for(let[d,p]of a.entries())go(n.readouts[d],p,l,c,d,e!==null);return{clips:a,clock:l,player:u,plots:f,dispose(){u.dispose(),f.dispose()}}}function WE(n,t){let e=n.map(({play:s},r)=>s.plots.map(o=>({...o,owner:t[r].name,sharing:`${o.title} ${o.unit}`,lines:o.lines.map(a=>({...a,clip:r}))})));return[...new Set(e.flat().map(s=>s.title))].flatMap(s=>e.flat().filter(r=>r.title===s))}function D_(n){if(n.length===1)return[""];let t=new Set(n.map(e=>e.point)).size<n.length;return n.map(e=>`point ${e.point+1}${t?`, ${e.title}`:""}`)}function XE(n,t,e){let{factors:i}=e.study,s=e.placesOf(n.point).map((r,o)=>`${i[o].texts[r]} ${i[o].unit}`.trim());return`${t}: ${s.join(", ")}`}function qE(n){let t=n.map(s=>s.stages.find(r=>r.driven)?.start??s.start),[e,i]=[Math.min(...n.map((s,r)=>s.start-t[r])),Math.max(...n.map((s,r)=>s.end-t[r]))];return{name:"whole runs",label:"time since the first drive acts",start:e,end:i,origins:t,whole:!0}}function $E(n,t){return n.study.quantities.filter(i=>GE.includes(i.group)).map(i=>D("tr",{},D("th",{scope:"row"},i.title),D("td",{},n.valueText(i,t))))}function YE(n,t){return n.study.built[t]?"This run was not kept, so it cannot be played here. The study keeps the runs of as many points as --keep says.":"There is nothing to play: this point cannot be built."}function ZE(n,t){let e=D("div");return e.innerHTML=n.numbers,D("details",{},D("summary",{},`States of ${t||"this run"}`),e)}function JE(n,t){let e=[`forficula run ${n.folder}/design.toml`,`forficula film ${n.folder} --out film.mp4`];return D("details",{},D("summary",{},t?`Commands for ${t}`:"Commands"),D("p",{className:"note"},"In the study’s folder, these run it again, and film it:"),D("pre",{},D("code",{},e.join(`
`))))}function U_(n,t,e,i){let s=n?.querySelector("table");if(!s)return;let r=[...s.tBodies[0].rows],o=D("p",{className:"note",role:"status"}),a=KE(t,()=>{let h=a.shown(),u=0;for(let[f,d]of r.entries())d.hidden=!h.has(t.study.verdicts[f]),u+=d.hidden?0:1;o.textContent=`${u} of ${r.length} points shown.`});for(let[h,u]of r.entries()){let f=D("button",{type:"button","aria-label":`open point ${h+1}`},u.cells[0].textContent);f.addEventListener("click",()=>i(h)),u.cells[0].replaceChildren(f)}let l=t.study.factors.length+1;for(let h of[s.tHead.rows[0],...r])h.cells[l].classList.add("words");QE(s,r,jE(t));let c=D("div",{className:"choices"},a.element,...e?[eC(e)]:[]);s.closest(".table").before(c,o),a.changed()}function KE(n,t){let e=new Map,i=n.study.words.flatMap(({word:r,sign:o,count:a},l)=>{if(!a)return[];let c=D("input",{type:"checkbox",checked:!0});return c.addEventListener("change",t),e.set(l,c),[D("label",{},c,D("span",{className:Ss(o),"aria-hidden":"true"},D("span",{},o)),`${r} (${a})`)]});return{element:D("fieldset",{className:"filter"},D("legend",{},"Show points that"),...i),changed:t,shown:()=>new Set([...e].filter(([,r])=>r.checked).map(([r])=>r))}}function jE(n){let{study:t}=n,e=t.statuses.map((r,o)=>o),i=t.factors.map((r,o)=>e.map(a=>r.values[n.placesOf(a)[o]])),s=t.quantities.filter(r=>["torque","time","work","energy"].includes(r.group)).map(r=>r.values);return[e,...i,t.statuses,...s]}function QE(n,t,e){let i=[...n.tHead.rows[0].cells];for(let[s,r]of i.entries()){let o=D("button",{type:"button"},...r.childNodes);r.replaceChildren(o),o.addEventListener("click",()=>{let a=r.getAttribute("aria-sort")==="ascending";for(let c of i)c.removeAttribute("aria-sort");r.setAttribute("aria-sort",a?"descending":"ascending");let l=t.map((c,h)=>h).sort((c,h)=>tC(e[s][c],e[s][h],a?-1:1)||c-h);n.tBodies[0].append(...l.map(c=>t[c]))})}i[0].setAttribute("aria-sort","ascending")}function tC(n,t,e){if(n===null||t===null)return(n===null)-(t===null);let i=typeof n=="number"?n-t:String(n).localeCompare(String(t),"en");return e*i}function eC(n){let t=D("button",{type:"button",className:"button"},"Download table.csv");return t.addEventListener("click",()=>{let e=URL.createObjectURL(new Blob([n],{type:"text/csv;charset=utf-8"}));D("a",{href:e,download:"table.csv"}).click(),setTimeout(()=>URL.revokeObjectURL(e),1e4)}),t}function O_(n){let t=v_(n.study,n.runs),e=N_(t),i=(a,l=null)=>{e.open(a,{play:!0,transition:l}),iC(e)},s=E_(t,(a,l)=>i(a,l.transition)),r=D("div",{},s.element,e.facts);document.getElementById("explorer").replaceChildren(D("div",{className:"explorer"},r,e.element)),U_(document.getElementById("points"),t,n.csv,a=>{s.show(a),i(a)});let o=nC(t,n.runs);return e.open(o),s.show(o),{model:t,map:s,panel:e,open:i}}function nC(n,t){let e=n.study.quantities.filter(o=>o.group==="torque"),i=o=>[n.study.verdicts[o],...e.map(a=>a.values[o]??1/0),o],s=(o,a)=>{let l=o.findIndex((c,h)=>c!==a[h]);return l>=0&&o[l]<a[l]};return t.map(o=>o.point).reduce((o,a)=>o===null||s(i(a),i(o))?a:o,null)??0}function iC({facts:n,element:t}){let{top:e}=t.getBoundingClientRect();if(e>=0&&e<.5*innerHeight)return;let i=n.getBoundingClientRect().left===t.getBoundingClientRect().left,s=matchMedia("(prefers-reduced-motion: reduce)").matches;(i?n:t).scrollIntoView({behavior:s?"auto":"smooth",block:"start"})}var sC={run:x_,compare:W0,curves:q0,study:O_,parts:p_,bench:mg},F_=JSON.parse(document.getElementById("data").textContent);function B_(n){let t=`What moves cannot be shown in this browser (${n.message}); the numbers below are all there.`;throw document.querySelector("main").prepend(D("p",{className:"note",role:"alert"},t)),n}function k_(n){window.forficula=n}try{let n=sC[F_.kind](F_);n instanceof Promise?n.then(k_,B_):k_(n)}catch(n){B_(n)}_o();})();
